#include <glassbox/base/rounding.h>

#include "study/extremes/common/depth.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c56 {

// The depth at distance z is B/z + A, with B = n f/(f - n) for planes at n and f. In float, the
// product A z, the sum and the quotient are rounded. This can put two depths in the wrong order if
// their relative separation is up to 2 u z/f + 4 u (1 - z/f), at most 4 u (u is the unit roundoff).
constexpr double kBound = 4 * double(unit_roundoff<float>);

Outcome measure_error(const DepthPath& path) {
  WorstError worst;
  for (const double distance : {0.2, 1.0, 10.0, 100.0, 1000.0, 9000.0}) {
    const double around =
        path.format == DepthFormat::kFloat32Reversed && path.detour == DepthPath::kNone
            ? 1e-7
            : distance * 0x1p-24 / path.near;
    const double confused = coarsest_confused(path, distance, around);
    worst.add(confused, kBound,
              fmt::format("depths that are {:.2g} apart are confused at the distance {}", confused,
                          distance));
  }
  return worst.outcome();
}

// 300 triangles of all sizes, tilted and intersecting each other, at distances from a hundredth of
// their width to ten times their width: the nearest one must be visible, in any order of drawing.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    for (std::uint64_t seed = 856; seed < 860; ++seed) {
      Random random(seed);
      std::vector<EyeTriangle> triangles;
      for (int i = 0; i < 300; ++i) {
        const bool fills = i % 20 == 0;
        const double distance = random.between(fills ? 4 : 1, 9);
        const double size = fills ? 20 : std::pow(2.0, random.between(-4, 1));
        const auto beside = [&] { return random.between(-0.5, 0.5); };
        const double x = beside() * distance, y = beside() * distance;
        EyeTriangle t;
        for (Point<Eye>& p : t) {
          p = {float(x + size * beside()), float(y + size * beside()),
               float(-distance + std::min(size, 4.0) * beside())};
        }
        triangles.push_back(t);
      }
      RayScene ray_scene = make_ray_scene(triangles, PerspectiveLens{0.9, 0.5, 16.0}, 256);
      ray_scene.separation = 1e-5;
      all.emplace_back(std::move(ray_scene));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c56

ExtremeCase c56_depth_ladder() {
  using namespace c56;
  const auto with = [](const DepthPath& path) { return [path] { return measure_error(path); }; };
  return {
      .id = "C-56",
      .name = "Ladder of nearly equal depths",
      .construction =
          "near plane 0.1, far plane 10,000; pairs of surfaces at distances 0.2 to 9,000, closer "
          "and closer to each other",
      .stage = "projection, depth",
      .right_answer =
          "reversed float distinguishes distances that differ by 4 u = 2.4e-7 of the distance, "
          "everywhere",
      .unit = "relative separation",
      .oracle = Oracle::kAnalytic,
      .ours = {"float, reversed range", with({.format = DepthFormat::kFloat32Reversed})},
      .naive = {"24 bits, standard range", with({.format = DepthFormat::kUnorm24})},
      .mutants = {{"16 bits", with({.format = DepthFormat::kUnorm16})},
                  {"the range is not reversed", with({.format = DepthFormat::kFloat32})}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
