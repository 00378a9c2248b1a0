// D-17's leaves: small squares anywhere in a slab, of which it is known how many lie behind each other.
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

// Parallel eyes, one pixel a unit, and a slab 480 units deep. A line through it, from whatever eye, meets leaves as Poisson has it: 3 on
// average, for three times the area is covered. Leaves are 6 units wide, and 160 units lie between two of them on a line: two lines that
// meet in a point at 0.35 radian are a leaf apart after 17 units, so that but for a tenth of the leaves they have nothing to do with each
// other.
inline constexpr double kDepth = 480, kLeaf = 6, kCovered = 3, kAngle = 0.35;
inline constexpr double kDistance = 400;  // from the eyes to the middle of the slab
// Eyes stand beside each other: what the other one sees lies up to 240 tan 0.35 = 88 px further to the sides for the first, and twice that
// for the second.
inline constexpr int kSourceWidth = 464, kSeenWidth = 96, kHeight = 32;  // px

inline Scene leaves() {
  constexpr double kHalfWidth = 330, kHalfHeight = 20;  // before all eyes
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
  // The slab and no more lies between the planes of the eye in front of it.
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

// P(N >= k) for N of Poisson's distribution.
inline double at_least(int k, double mean) {
  double term = std::exp(-mean), below = 0;
  for (int n = 0; n < k; ++n) below += term, term *= mean / (n + 1);
  return 1 - below;
}

// What one eye sees at the optical depth t it sees with the density e^-t, and there k layers of another eye end before with P(N >= k), of
// which the mean is t: of what is seen, that none of `eyes` has. For one eye of an endless slab 2^-k.
inline double missing_share(double covered, int layers, int eyes) {
  constexpr int kSteps = 2000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = covered * (i + 0.5) / kSteps;
    sum += std::exp(-t) * std::pow(at_least(layers, t), eyes);
  }
  return sum * covered / kSteps / (1 - std::exp(-covered));
}

// The mean of min(N, k): P(N >= 1) + ... + P(N >= k).
inline double kept_layers(double covered, int layers) {
  double sum = 0;
  for (int k = 1; k <= layers; ++k) sum += at_least(k, covered);
  return sum;
}

// A sample at depth u, 1 in front and 0 behind, takes in what lies within epsilon u behind it: a counter that is dead for that long after
// each count, which counts T/(1 + T epsilon u) of T a unit. The share that it misses of all.
inline double merged_share(double covered, double epsilon) {
  return 1 - std::log1p(covered * epsilon) / (covered * epsilon);
}

}  // namespace glassbox::study::d17
