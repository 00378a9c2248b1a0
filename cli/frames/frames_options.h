// The options of render --frames, along a --path or round a --turntable.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cli/frames/camera_path.h"
#include "cli/frames/frame_range.h"
#include "cli/options/cli_fwd.h"
#include "cli/options/eyes_options.h"
#include "cli/options/picture_options.h"

#include <glassbox/base/error.h>

namespace glassbox {

struct FramesOptions {
  std::optional<FrameRange> range;
  std::optional<std::string> path;  // the file of a camera path; absent with --turntable
  bool turntable = false;
  // The largest parallax in front of the window and behind it, in per cent of the width.
  std::array<double, 2> budget_percent{kComfortablePercent, kComfortablePercent};
  double release_frames = 15;
  std::optional<double> max_step;  // largest change of the separation per frame, world units
  // the file of the plot; absent: named after the pictures
  std::optional<std::string> plot;
  std::vector<const CLI::Option*> options;  // the options that add_frames_options has added

  bool requests_sequence() const { return range || path || turntable; }
};

void add_frames_options(CLI::App& command, FramesOptions& frames);

// Adds --frames, --path and --turntable only, for pictures for one eye.
void add_sequence_options(CLI::App& command, FramesOptions& frames);

// Refuses options that contradict each other or make no sense together.
Result<void> check_frames_options(const PictureOptions& picture, bool for_two_eyes,
                                  const FramesOptions& frames);

// Refuses options that say what the path's file says already.
Result<void> check_path_options(const PictureOptions& picture, const CameraPath& path);

}  // namespace glassbox
