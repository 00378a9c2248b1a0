// The leaves scene (D-17): small squares at random places in a slab; it is known how many of them
// are behind each other.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/view.h>

namespace glassbox::study::d17 {

// Parallel eyes with one pixel per unit, and a slab 480 units deep. The number of leaves on a line
// through it, from any eye, has a Poisson distribution with mean 3, because the leaves have three
// times the area of the slab's front. Leaves are 6 units wide, and the mean distance of two leaves
// on a line is 160 units. Two lines that cross at an angle of 0.35 radian are a leaf's width apart
// after 17 units, so except for a tenth of the leaves, the leaves on one line are independent of
// those on the other.
inline constexpr double kDepth = 480, kLeaf = 6, kCovered = 3, kAngle = 0.35;
inline constexpr double kDistance = 400;  // from the eyes to the middle of the slab
// The eyes are side by side. What the other eye sees is up to 240 tan 0.35 = 88 px further to the
// sides in the picture of the first eye, and up to twice that in the picture of the second.
inline constexpr int kSourceWidth = 464, kSeenWidth = 96, kHeight = 32;  // in px

inline Scene leaves() {
  constexpr double kHalfWidth = 330, kHalfHeight = 20;  // covers the pictures of all eyes
  Scene scene;
  scene.materials[add_material(scene, "leaves", {1, 1, 1, 1})].unlit = true;
  Mesh mesh;
  Random random(17);
  const int count = int(kCovered * 4 * kHalfWidth * kHalfHeight / (kLeaf * kLeaf));
  for (int i = 0; i < count; ++i) {
    const double x = random.between(-kHalfWidth, kHalfWidth);
    const double y = random.between(-kHalfHeight, kHalfHeight);
    const double z = random.between(-kDepth / 2, kDepth / 2), h = kLeaf / 2;
    const auto channel = [&] { return float(random.integer(1, 255)) / 255.0f; };
    const float r = channel(), g = channel(), b = channel();
    const std::array<std::uint32_t, 4> corners{
        add_position(mesh, x - h, y - h, z), add_position(mesh, x + h, y - h, z),
        add_position(mesh, x + h, y + h, z), add_position(mesh, x - h, y + h, z)};
    add_flat_face(mesh, corners, add_color(mesh, {r, g, b, 1}));
  }
  add_object(scene, std::move(mesh));
  return scene;
}

inline View eye_at_angle(double radians, int width) {
  Camera camera;
  // For the eye in front, the near and far planes are exactly the faces of the slab.
  const bool is_level = radians == 0;
  camera.lens = OrthographicLens{kHeight / 2.0, is_level ? kDistance - kDepth / 2 : 1.0,
                                 is_level ? kDistance + kDepth / 2 : 2 * kDistance};
  camera.world_from_eye = camera_pose(Point<World, double>(kDistance * std::sin(radians), 0,
                                                           kDistance * std::cos(radians)),
                                      Point<World, double>(0, 0, 0), {0, 1, 0})
                              .value();
  return make_view(camera, width, kHeight).value();
}

// ---- the laws ----

// The probability P(N >= k), if N has a Poisson distribution with this mean.
inline double at_least(int k, double mean) {
  double term = std::exp(-mean), below = 0;
  for (int n = 0; n < k; ++n) below += term, term *= mean / (n + 1);
  return 1 - below;
}

// The fraction of visible surfaces that are in none of the first k layers of any of `eyes` eyes. An
// eye sees a surface at the optical depth t (the mean number of surfaces in front of it) with the
// density e^-t. In another eye's k layers it is missing if k or more surfaces are in front of it,
// which has the probability P(N >= k) for a Poisson distribution of N with the mean t. For one eye
// and an endless slab, the result is 2^-k.
inline double missing_share(double covered, int layers, int eyes) {
  constexpr int kSteps = 2000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = covered * (i + 0.5) / kSteps;
    sum += std::exp(-t) * std::pow(at_least(layers, t), eyes);
  }
  return sum * covered / kSteps / (1 - std::exp(-covered));
}

// The mean of min(N, k), where N is the number of surfaces on a line: P(N >= 1) + ... + P(N >= k).
inline double kept_layers(double covered, int layers) {
  double sum = 0;
  for (int k = 1; k <= layers; ++k) sum += at_least(k, covered);
  return sum;
}

// Returns the fraction of samples that are merged into others. A sample at depth u (1 in front, 0
// behind) absorbs the samples within epsilon u behind it, as a particle counter is dead for some
// time after each count: of T samples per unit of depth, T/(1 + T epsilon u) remain.
inline double merged_share(double covered, double epsilon) {
  return 1 - std::log1p(covered * epsilon) / (covered * epsilon);
}

}  // namespace glassbox::study::d17
