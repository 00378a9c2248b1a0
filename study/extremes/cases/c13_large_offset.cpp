#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/sphere.h>
#include "exact/camera.h"
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/transform.h"

namespace glassbox::study {
namespace c13 {

using exact::Decimal;

Outcome measure_error(ToEye to_eye) {
  Random random(713);
  WorstError worst;
  for (const double offset : {1e2, 1e4, 1e6, 1e8}) {
    const WorldVector place{offset, -offset, offset * 0.5};
    const WorldPoint eye = WorldPoint{3, 4, 5} + place, target = WorldPoint{0, 0, 0} + place;
    const auto view = look_at(eye, target, {0, 1, 0}).value();
    const auto exact_view = exact::look_at(eye, target, {0, 1, 0});
    for (int i = 0; i < 100; ++i) {
      const Point<Object> p{float(random.between(-1, 1)), float(random.between(-1, 1)),
                            float(random.between(-1, 1))};
      const Point<Eye> image = to_eye(view, translate<World, Object>(place), p);
      const exact::Vector4<Decimal> world{Decimal(place.x) + Decimal(double(p.x)),
                                          Decimal(place.y) + Decimal(double(p.y)),
                                          Decimal(place.z) + Decimal(double(p.z)), Decimal(1)};
      const auto exact = exact_view * world;
      // With the matrix M, the point x and the unit roundoff u. In float: u |M||x| from the rounded
      // entries and gamma_4 |M||x| from the transform, where |M||x| <= sqrt(3) + 7.1 < 9. In
      // double: 24 u times 2.3 offset, which is 8 for the translation with three products and sums
      // of this size, and 16 for the rotation itself.
      const double bound =
          9 * (unit_roundoff<float> + gamma<float>(4)) + 24 * 2.3 * offset * unit_roundoff<double>;
      const std::string where = fmt::format("offset {:g}", offset);
      worst.add(exact::error_of(double(image.x), exact[0]), bound, where);
      worst.add(exact::error_of(double(image.y), exact[1]), bound, where);
      worst.add(exact::error_of(double(image.z), exact[2]), bound, where);
    }
  }
  return worst.outcome();
}

// A ball far from the origin, seen by a camera that is equally far from it.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    for (const double offset : {1e2, 1e4, 1e6}) {
      const WorldVector place{offset, -offset, offset * 0.5};
      Scene ball = make_sphere(6);
      for (Node& node : ball.nodes) {
        node.world_from_node = translate<World>(place) * node.world_from_node;
      }
      all.emplace_back(
          make_ray_scene(ball, camera_at(WorldPoint{2, 3, 4} + place, {-2, -3, -4}), 64, 64));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c13

ExtremeCase c13_large_offset() {
  using namespace c13;
  return {
      .id = "C-13",
      .name = "An object far from the origin",
      .construction =
          "an object of size 2 and an eye at the distance 7 from it, both 1e2 .. 1e8 from the "
          "origin",
      .stage = "to eye space",
      .right_answer =
          "the same positions in eye space as at the origin, to 5 u |M||x| in float (2.7e-6) and "
          "55 u times the offset in double",
      .unit = "world unit",
      .oracle = Oracle::kExtended,
      .ours = {"matrices are composed in double and rounded once",
               [] { return measure_error(composed_in_double); }},
      .naive = {"float world positions", [] { return measure_error(naive::through_float_world); }},
      .mutants = {{"matrices are composed in float",
                   [] { return measure_error(naive::composed_in_float); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
