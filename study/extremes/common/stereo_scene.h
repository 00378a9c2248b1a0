// Scenes for two eyes, and checks of their pictures.
#pragma once

#include <cstdint>
#include <string>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/stereo/render_pair.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/extremes/common/ray_scene.h"

namespace glassbox::study {

struct StereoScene {
  Scene scene;
  View centre;
  StereoPair pair;
};

// A built-in scene, seen by its own camera or framed. The window is at the distance of the scene's
// centre, and half the separation is the fraction `share` of that distance.
StereoScene make_stereo_scene(const std::string& name, double share, int width = 320,
                              int height = 180);

struct EyePictures {
  Image<Rgba8> left, right;
};

// Draws each eye in a separate run of the staged reference: the right result for a pair.
EyePictures draw_eyes_separately(const StereoScene& scene);

// The ray scene that one eye sees: from the eye's own place, through the same window. `centre` is
// the ray scene of the camera between the eyes, with a perspective lens.
RayScene eye_ray_scene(RayScene centre, const StereoPair& pair, Side side);
// An engine that draws one eye's picture of a pair with the given engine. The views that it gets
// are those of the camera between the eyes.
TestedEngine engine_for_eye(const TestedEngine& engine, const StereoPair& pair, Side side);

// A ray scene seen by both eyes, computed once for all engines.
class StereoReference {
public:
  StereoReference(const RayScene& centre, const StereoPair& pair);
  Outcome measure_error(const TestedEngine& engine) const;

private:
  StereoPair pair_;
  RayCastReference left_, right_;
};

// The number of pixels that differ between two pictures; for pairs, the sum over both eyes.
std::uint64_t pixels_that_differ(const Image<Rgba8>& a, const Image<Rgba8>& b);
std::uint64_t pixels_that_differ(const EyePictures& a, const EyePictures& b);

// A camera at the origin that looks along -z, with a vertical angle of view of 45 degrees.
View view_from_origin(int width, int height, double near = 0.5, double far = 1000);

}  // namespace glassbox::study
