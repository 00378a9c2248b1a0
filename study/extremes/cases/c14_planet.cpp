#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>

#include <glassbox/mesh/builtin/cube.h>
#include "exact/number.h"
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/transform.h"

namespace glassbox::study {
namespace c14 {

using exact::Rational;

Outcome measure_error(ToEye to_eye) {
  // The camera's axes are those of the world, and its position needs few bits, so only the
  // coordinates of the points are rounded.
  const WorldVector place{6.378e6, 0, 0};
  const auto view =
      look_at(WorldPoint{0, 0, 2} + place, WorldPoint{0, 0, 0} + place, {0, 1, 0}).value();
  WorstError worst;
  for (const float half : {0.5f, 0.4f, 0.1f}) {
    for (int corner = 0; corner < 8; ++corner) {
      const Point<Object> p{(corner & 1) != 0 ? half : -half, (corner & 2) != 0 ? half : -half,
                            (corner & 4) != 0 ? half : -half};
      const Point<Eye> image = to_eye(view, translate<World, Object>(place), p);
      const std::string where = fmt::format("a cube of {:.1f} m", 2 * half);
      worst.add(exact::error_of(double(image.x), Rational(double(p.x))), 0, where);
      worst.add(exact::error_of(double(image.y), Rational(double(p.y))), 0, where);
      // Only z - 2 is rounded, once; its size is below 4, so the error is at most half an ulp of 2.
      worst.add(exact::error_of(double(image.z), Rational(double(p.z)) - Rational(2)), 0x1p-23,
                where);
    }
  }
  return worst.outcome();
}

Point<Eye> float_view(const Transform<Eye, World>& view, const Transform<World, Object>& model,
                      const Point<Object>& p) {
  const Transform<Eye, World> rounded{glm::dmat4(round_to_float(view).columns)};
  Transform<World, Object> nearly = model;
  nearly.at(0, 3) = double(float(model.at(0, 3) + double(p.x)));
  return round_to_float(rounded * nearly) * Point<Object>(0, p.y, p.z);
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference cube([] {
    const WorldVector place{6.378e6, 0, 0};
    Scene scene = make_cube();
    for (Node& node : scene.nodes) {
      node.world_from_node =
          translate<World>(place) * scale<World>(0.5, 0.5, 0.5) * node.world_from_node;
    }
    return make_ray_scene(scene, camera_at(WorldPoint{1, 1.5, 2} + place, {-1, -1.5, -2}), 96, 96);
  }());
  return cube.measure_error(engine);
}

}  // namespace c14

ExtremeCase c14_planet() {
  using namespace c14;
  return {
      .id = "C-14",
      .name = "A cube of a metre on a planet",
      .construction = "cubes of 1, 0.8 and 0.2 m at 6.378e6 m from the origin, an eye 2 m away",
      .stage = "to eye space",
      .right_answer =
          "in eye space x and y are exactly those of the model, and z - 2 is rounded once",
      .unit = "m",
      .oracle = Oracle::kRational,
      .ours = {"matrices are composed in double and rounded once",
               [] { return measure_error(composed_in_double); }},
      .naive = {"float world positions", [] { return measure_error(naive::through_float_world); }},
      .mutants = {{"vertices are transformed to world space in float",
                   [] { return measure_error(float_view); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
