// The cameras of a sequence, one per frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/frames/camera_path.h"
#include "cli/frames/frame_range.h"
#include "cli/options/camera_options.h"
#include "cli/options/picture_options.h"

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// A camera that goes once around a scene: the last picture is followed by the first. It turns about
// the axis through `target` in the direction `up`, counterclockwise if one looks against this
// direction.
struct Turntable {
  Point<World, double> target;
  Vector<World, double> from_target;  // vector from the target to the eye in the first frame
  std::array<double, 3> up{0, 1, 0};

  // The camera of frame `number` (from 1) of `count`. It is turned by 360 (number - 1)/count
  // degrees; quarter turns are exact, because sin_cos_degrees is.
  CameraPose camera(int number, int count) const;
};

// Makes the turntable. The target is --look-at, or else the scene's centre. The eye starts at
// --eye, or else in the automatic camera's direction, so far away that everything is in every
// picture. --up and --fov are used; a camera of the scene is not.
Result<Turntable> make_turntable(const Scene& scene, const CameraOptions& options, double aspect);

struct SequenceFrame {
  int number = 1;
  double time = 0;
  CameraPose pose;
  Camera camera;
  View centre;
  double window = 0;  // the window's distance that the path or the options give; 0 for one eye
};

// Returns the frames of the range: along the path, or round the turntable if there is one (the path
// then has no keyframes). An error names the frame whose camera is invalid.
Result<std::vector<SequenceFrame>> make_sequence_frames(const Scene& scene,
                                                        const PictureOptions& picture,
                                                        const CameraPath& path,
                                                        const std::optional<Turntable>& turntable,
                                                        const FrameRange& range, bool stereo);

// The command-line words that draw the frame as a single picture: the given options, with the
// frame's camera. `pair` is null if there is only one eye.
std::vector<std::string> frame_command_words(const SequenceFrame& frame, const StereoPair* pair,
                                             const std::vector<const CLI::Option*>& options);

}  // namespace glassbox
