// Scenes seen by two eyes, and what is wrong with their pictures.
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

// A built-in scene seen by its own camera or framed; half the separation a share of the window's distance, which is that of
// the scene's centre.
PairScene pair_scene(const std::string& name, double share, int width = 320, int height = 180);

struct EyePictures {
  Image<Rgba8> left, right;
};

// Each eye by a run of its own, with the staged reference: what a pair has to look like.
EyePictures each_eye_alone(const PairScene& scene);

// What one eye sees of what the camera between the eyes looks at, through a perspective lens: from its own place, through the same
// window.
Vista seen_by(Vista centre, const StereoPair& pair, Side side);
// One eye of the pairs that a drawer draws. The view that it is given is the camera's between the eyes.
Drawer eye_of(const Drawer& drawer, const StereoPair& pair, Side side);

// A vista from both eyes, worked out once for all drawers.
class PairDrawn {
public:
  PairDrawn(const Vista& centre, const StereoPair& pair);
  Outcome judge(const Drawer& drawer) const;

private:
  StereoPair pair_;
  SightDrawn left_, right_;
};

// Pixels that differ from it, of both eyes.
std::uint64_t pixels_that_differ(const Image<Rgba8>& a, const Image<Rgba8>& b);
std::uint64_t pixels_that_differ(const EyePictures& a, const EyePictures& b);

// A camera at the origin that looks along -z, with a vertical angle of 45 degrees.
View view_from_origin(int width, int height, double near = 0.5, double far = 1000);

}  // namespace glassbox::study
