// Scenes for two eyes, and checks of their pictures.
#pragma once

#include <cstdint>
#include <string>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/stereo/render_pair.h>

#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/sight.h"
#include "study/extremes/kit/vista.h"

namespace glassbox::study {

struct PairScene {
  Scene scene;
  View centre;
  StereoPair pair;
};

// A built-in scene, seen by its own camera or framed. The window is at the distance of the scene's
// centre, and half the separation is this share of that distance.
PairScene pair_scene(const std::string& name, double share, int width = 320, int height = 180);

struct EyePictures {
  Image<Rgba8> left, right;
};

// Draws each eye in a separate run of the staged reference: the right result for a pair.
EyePictures each_eye_alone(const PairScene& scene);

// The vista that one eye sees, for a vista of the camera between the eyes with a perspective lens:
// from the eye's own place, through the same window.
Vista seen_by(Vista centre, const StereoPair& pair, Side side);
// A drawer that draws one eye of a pair with the given drawer. Its views are those of the camera
// between the eyes.
Drawer eye_of(const Drawer& drawer, const StereoPair& pair, Side side);

// A vista seen by both eyes, computed once for all drawers.
class PairDrawn {
public:
  PairDrawn(const Vista& centre, const StereoPair& pair);
  Outcome judge(const Drawer& drawer) const;

private:
  StereoPair pair_;
  SightDrawn left_, right_;
};

// The number of pixels that differ; for pairs, in both eyes.
std::uint64_t pixels_that_differ(const Image<Rgba8>& a, const Image<Rgba8>& b);
std::uint64_t pixels_that_differ(const EyePictures& a, const EyePictures& b);

// A camera at the origin that looks along -z, with a vertical angle of view of 45 degrees.
View view_from_origin(int width, int height, double near = 0.5, double far = 1000);

}  // namespace glassbox::study
