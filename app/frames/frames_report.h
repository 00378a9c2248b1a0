// The report on a sequence: every frame's numbers, as text, as JSON and for the plot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/frames/eye_plan.h"
#include "cli/frames/frame_range.h"
#include "cli/frames/sequence_frames.h"
#include "cli/options/arguments.h"

#include <glassbox/pipeline/stereo/parallax_budget.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>

namespace glassbox::app {

struct FrameRecord {
  int number = 1;
  double time = 0;
  std::string image;
  // These members are set if there are two eyes. All except `pair` are computed from the distances
  // at the pixels of both pictures. in_front_px and behind_px are >= 0.
  StereoPair pair;
  std::optional<DepthSpan> seen;
  double in_front_px = 0, behind_px = 0;
};

struct FramesReport {
  std::string scene, path;  // path is empty for a turntable
  FrameRange range;
  Size size;
  std::vector<FrameRecord> frames;
  std::optional<EyePlan> eyes;
  ParallaxBudget budget;
  std::string plot;  // empty: no plot was asked for
  double total_ms = 0;
};

FrameRecord record_of(const SequenceFrame& shot, const std::string& image);
void measure_parallax(FrameRecord& record, const View& centre, const StereoPair& pair,
                      const std::optional<DepthSpan>& seen);

std::string frames_text(const FramesReport& report);
nlohmann::ordered_json frames_json(const FramesReport& report);

// Separation, window and largest parallax over the frames, as an SVG picture.

// Draws a plot that is readable on a light background and a dark one, with a description in words
// (title, desc) for people who cannot see it. The report must have eyes and at least one frame.
std::string plot_svg(const FramesReport& report);

}  // namespace glassbox::app
