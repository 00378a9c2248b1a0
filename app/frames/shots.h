// The cameras of a sequence, one a frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/frames/camera_path.h"
#include "app/frames/frame_range.h"
#include "app/frames/turntable.h"
#include "app/options/picture_options.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

namespace glassbox::app {

struct Shot {
  int number = 1;
  double time = 0;
  CameraAt at;
  Camera camera;
  View centre;
  double window = 0;  // where the path or the options want it; 0 where there are no eyes
};

// Those of the range, along the path or, where there is one, round the turntable; the path has no keyframes then. An error names the frame
// whose camera cannot be.
Result<std::vector<Shot>> make_shots(const Scene& scene, const PictureOptions& picture,
                                     const CameraPath& path,
                                     const std::optional<Turntable>& turntable,
                                     const FrameRange& range, bool stereo);

// The words that make the frame as a single picture: those given, and the shot's camera. `pair` is null without eyes.
std::vector<std::string> words_for(const Shot& shot, const StereoPair* pair,
                                   const std::vector<const CLI::Option*>& options);

}  // namespace glassbox::app
