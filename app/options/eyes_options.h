// The two eyes on the command line: how far apart, and where the stereo window stands.
#pragma once

#include <optional>
#include <string>

#include "app/options/cli_fwd.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::app {

struct EyesOptions {
  // From eye to eye, world units; absent: a thirtieth of the window's distance.
  std::optional<double> separation;
  std::optional<double> window;  // along the gaze, world units; absent: at the point of interest
  // The one eye whose picture is wanted; absent: the camera between them.
  std::optional<Side> seen_by;
};

void add_eyes_options(CLI::App& command, EyesOptions& eyes);

// What is automatic where the options are silent:
//
// The window stands at the point of interest: where the camera looks (`look_at`, a distance along the gaze), else the centre
// of what the scene draws, else, where that is not between the near and far planes, at the distance with as much depth
// before it as behind it, 1/f = (1/near + 1/far)/2.
//
// The eyes are a thirtieth of the window's distance apart, or less: so that what a quick look at the scene finds has no more
// parallax than kComfortablePercent of the picture's width.
inline constexpr double kComfortablePercent = 3;

struct ChosenPair {
  StereoPair pair;
  std::string window_is_at;        // what the window's distance comes from, in words
  std::string separation_is_from;  // and the separation
};

// The pair that the options ask for, checked.
Result<ChosenPair> choose_pair(const Scene& scene, const View& centre,
                               const RenderSettings& settings, const EyesOptions& eyes,
                               std::optional<double> look_at);

}  // namespace glassbox::app
