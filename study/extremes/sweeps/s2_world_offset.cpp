#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <glassbox/base/random.h>
#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/bounds.h>
#include <glassbox/pipeline/look_at.h>

#include "study/extremes/sweep.h"

namespace glassbox::study {

namespace s2 {

// An object a few units large is `offset` away from the origin of the world; the eye looks at it
// from a distance of five units.
struct OffsetScene {
  double offset;
  Transform<World, Object> world_from_object;
  Transform<Eye, World> eye_from_world;
};
OffsetScene scene_at_offset(double offset) {
  const Point<World, double> at(offset, offset / 2, -offset / 4);
  return {offset, translate<World, Object>(at - Point<World, double>(0, 0, 0)),
          look_at({at.x + 3, at.y + 0.0, at.z + 4}, at, {0, 1, 0}).value()};
}

using LongVector = glm::vec<3, long double>;

// Computes the position with the numbers of the matrices in 64 bits of mantissa, which is right to
// 2^-60 of the offset.
LongVector exactly(const OffsetScene& scene, const Point<Object>& p) {
  LongVector eye(0);
  const auto& m = scene.eye_from_world;
  const auto& w = scene.world_from_object;
  const LongVector world(static_cast<long double>(p.x) + static_cast<long double>(w.at(0, 3)),
                         static_cast<long double>(p.y) + static_cast<long double>(w.at(1, 3)),
                         static_cast<long double>(p.z) + static_cast<long double>(w.at(2, 3)));
  for (int row = 0; row < 3; ++row) {
    eye[row] = static_cast<long double>(m.at(row, 3));
    for (int k = 0; k < 3; ++k) eye[row] += static_cast<long double>(m.at(row, k)) * world[k];
  }
  return eye;
}

struct PositionWithBound {
  glm::dvec3 position, bound;
};

// Computes the position in world space in float, and then the position in eye space with a float
// matrix that contains the eye's translation.
PositionWithBound in_float(const OffsetScene& scene, const Point<Object>& p) {
  const double u = double(unit_roundoff<float>);
  const auto world_from_object = round_to_float(scene.world_from_object);
  const auto eye_from_world = round_to_float(scene.eye_from_world);
  const Point<World> world = world_from_object * p;
  const Point<Eye> eye = eye_from_world * world;
  const glm::dvec4 world_bound =
      // two rounding errors: of the translation and of the sum
      2 * u * glm::abs(glm::dvec4(world.x, world.y, world.z, 0));
  const glm::dvec4 bound =
      transform_bound(eye_from_world.columns, {world.x, world.y, world.z, 1}, world_bound,
                      rounding_bound(scene.eye_from_world.columns));
  return {{eye.x, eye.y, eye.z}, glm::dvec3(bound)};
}

// The pipeline's method: one matrix composed in double, where the offsets cancel, and rounded once.
PositionWithBound composed(const OffsetScene& scene, const Point<Object>& p) {
  const Transform<Eye, Object> exact = scene.eye_from_world * scene.world_from_object;
  const auto eye_from_object = round_to_float(exact);
  const Point<Eye> eye = eye_from_object * p;
  const glm::dmat4 composing =
      product_bound(scene.eye_from_world.columns, scene.world_from_object.columns);
  const glm::dvec4 bound =
      transform_bound(eye_from_object.columns, {p.x, p.y, p.z, 1}, glm::dvec4(0),
                      rounding_bound(exact.columns) + composing);
  return {{eye.x, eye.y, eye.z}, glm::dvec3(bound)};
}

PositionWithBound in_double(const OffsetScene& scene, const Point<Object>& p) {
  const Point<Object, double> object(p.x, p.y, p.z);
  const Point<Eye, double> eye = scene.eye_from_world * (scene.world_from_object * object);
  const glm::dvec4 size = magnitude(scene.eye_from_world.columns,
                                    {scene.offset + 2, scene.offset + 2, scene.offset + 2, 1});
  return {{eye.x, eye.y, eye.z}, glm::dvec3(size * gamma<double>(6))};
}

SweepSeries series_of(const char* name, bool ours,
                      PositionWithBound (*compute)(const OffsetScene&, const Point<Object>&)) {
  SweepSeries series{name, ours};
  for (int half = 0; half <= 18; ++half) {
    const OffsetScene scene = scene_at_offset(std::pow(10.0, half / 2.0));
    Random random(100);
    SweepPoint worst{scene.offset, 0, 0};
    for (int i = 0; i < 200; ++i) {
      const auto coordinate = [&] { return float(random.between(-1, 1)); };
      const Point<Object> p{coordinate(), coordinate(), coordinate()};
      const PositionWithBound found = compute(scene, p);
      const LongVector exact = exactly(scene, p);
      for (int k = 0; k < 3; ++k) {
        worst.error = std::max(
            worst.error, double(std::abs(static_cast<long double>(found.position[k]) - exact[k])));
        worst.bound = std::max(*worst.bound, found.bound[k]);
      }
    }
    series.points.push_back(worst);
  }
  return with_limit(std::move(series), 1e-3);
}

std::vector<SweepSeries> world_offset_series() {
  return {series_of("composed in double, rounded once", true, composed),
          series_of("float, step by step", false, in_float),
          series_of("double, step by step", false, in_double)};
}

}  // namespace s2

Sweep s2_world_offset() {
  using namespace s2;
  return {
      .name = "world-offset",
      .title = "Distance of the scene from the world's origin",
      .question = "How far from the origin may a scene be built before its vertices shake?",
      .axis = "offset of object and eye",
      .axis_unit = "units",
      .error = "largest error of a coordinate in eye space",
      .error_unit = "units",
      .reference = "the same matrices applied in 64 bits of mantissa",
      .bound = "gamma_n |M||x| + |M| dx + dM |x| (pipeline/bounds.h)",
      .tolerance = "an error of a thousandth of a unit, which is a millimetre if units are metres",
      .series = world_offset_series};
}

}  // namespace glassbox::study
