// The cameras of a sequence, one per frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/frames/camera_path.h"
#include "cli/frames/frame_range.h"
#include "cli/frames/turntable.h"
#include "cli/options/picture_options.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

struct Shot {
  int number = 1;
  double time = 0;
  CameraAt at;
  Camera camera;
  View centre;
  double window = 0;  // the window that the path or the options want; 0 if there are no two eyes
};

// The shots of the range: along the path, or round the turntable if there is one (the path then has
// no keyframes). An error names the frame whose camera is invalid.
Result<std::vector<Shot>> make_shots(const Scene& scene, const PictureOptions& picture,
                                     const CameraPath& path,
                                     const std::optional<Turntable>& turntable,
                                     const FrameRange& range, bool stereo);

// The command-line words that draw the frame as a single picture: the given options, with the
// shot's camera. `pair` is null if there is only one eye.
std::vector<std::string> words_for(const Shot& shot, const StereoPair* pair,
                                   const std::vector<const CLI::Option*>& options);

}  // namespace glassbox
