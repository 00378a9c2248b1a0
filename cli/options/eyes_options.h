// The command-line options of the two eyes: the distance between them, and the distance of the
// stereo window.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

struct EyesOptions {
  // The distance between the eyes, world units; absent: a thirtieth of the window's distance.
  std::optional<double> separation;
  // The stereo window's distance along the gaze, world units; absent: at the point of interest.
  std::optional<double> window;
  // The eye whose picture is drawn alone; absent: the camera between the eyes.
  std::optional<Side> seen_by;
};

void add_eyes_options(CLI::App& command, EyesOptions& eyes);

// Values that are chosen if no option gives them:
//
// The window is at the point of interest: where the camera looks (`look_at`, a distance along the
// gaze), else the centre of what the scene draws. If this point is not between the near and far
// planes, the window is at the distance f with as much depth in front of it as behind it, 1/f =
// (1/near + 1/far)/2.
//
// The eyes are a thirtieth of the window's distance apart, or less: such that the depths found by a
// quick look at the scene have no more parallax than kComfortablePercent of the picture's width.
inline constexpr double kComfortablePercent = 3;

struct ChosenPair {
  StereoPair pair;
  std::string window_is_at;        // what the window's distance was computed from, in words
  std::string separation_is_from;  // what the separation was computed from, in words
};

// The two eyes that the options give. An error if they are not valid.
Result<ChosenPair> choose_pair(const Scene& scene, const View& centre,
                               const RenderSettings& settings, const EyesOptions& eyes,
                               std::optional<double> look_at);

}  // namespace glassbox
