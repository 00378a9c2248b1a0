#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/sphere.h>
#include "exact/matrix.h"
#include "exact/number.h"
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c15 {

using exact::Decimal;
constexpr int kDepth = 100;

using Compose = glm::dmat4 (*)(const std::vector<WorldMap>&);

std::vector<WorldMap> hierarchy() {
  Random random(715);
  std::vector<WorldMap> levels;
  for (int i = 0; i < kDepth; ++i) {
    const WorldVector axis{random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)};
    // The scales are larger and smaller than 1 in turn, so that the object keeps its size on the
    // whole.
    const double s = i % 2 == 0 ? 1.25 : 0.8;
    const WorldMap turn = rotate_degrees<World>(axis, random.between(0, 360)).value();
    const WorldVector aside{random.between(-1, 1), random.between(-1, 1), 1};
    levels.push_back(turn * scale<World>(s, s, s) * translate<World>(aside));
  }
  return levels;
}

Outcome measure_error(Compose compose) {
  const std::vector<WorldMap> levels = hierarchy();
  const glm::dmat4 product = compose(levels);
  auto exact = exact::Matrix4<Decimal>::identity();
  WorstError worst;
  for (const WorldMap& level : levels) {
    exact = exact * exact::exactly<Decimal>(level);
  }
  // Level i multiplies the product P of the levels before it by a matrix M, with rounding errors of
  // gamma_4 |P||M|. The later levels, rotations and scales, enlarge these errors by at most 1.25.
  // |P||M| is at most sqrt(3) 1.25 in the linear part and 4 (3 1.25 + i) in the last column. Over
  // 100 levels this is less than 100 gamma_4 1.25 4 (4 + 100).
  const double bound = kDepth * gamma<double>(4) * 1.25 * 4 * (4 + kDepth);
  add_entry_errors(worst, WorldMap(product), exact, 4, bound, "object to world");
  // Transforms a point to the world and back again.
  const auto back = inverse_affine(WorldMap(product));
  const WorldPoint p{1, 2, 3};
  const auto there = exact * exact::exactly<Decimal>(p);
  const WorldPoint home =
      back ? *back * WorldPoint(double(there[0]), double(there[1]), double(there[2]))
           : WorldPoint(HUGE_VAL, 0, 0);
  worst.add(length(home - p), 1e-6, "the matrix times its inverse");
  return worst.outcome(fmt::format("{:.1e} there and back", length(home - p)));
}

glm::dmat4 in_double(const std::vector<WorldMap>& levels) {
  WorldMap product;
  for (const WorldMap& level : levels) product = product * level;
  return product.columns;
}
glm::dmat4 in_float(const std::vector<WorldMap>& levels) {
  glm::mat4 product(1);
  for (const WorldMap& level : levels) product = product * glm::mat4(level.columns);
  return glm::dmat4(product);
}
glm::dmat4 from_the_leaf(const std::vector<WorldMap>& levels) {
  glm::dmat4 product(1);
  for (const WorldMap& level : levels) product = level.columns * product;
  return product;
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference ball([] {
    Scene scene = make_sphere(6);
    WorldMap product;
    for (const WorldMap& level : hierarchy()) product = product * level;
    for (Node& node : scene.nodes) node.world_from_node = product * node.world_from_node;
    const WorldPoint centre = product * WorldPoint(0, 0, 0);
    return make_ray_scene(scene, camera_at(centre + WorldVector{1, 2, 4}, {-1, -2, -4}), 96, 96);
  }());
  return ball.measure_error(engine);
}

}  // namespace c15

ExtremeCase c15_deep_hierarchy() {
  using namespace c15;
  return {
      .id = "C-15",
      .name = "A hundred nested transforms",
      .construction =
          "100 nested nodes with a rotation, a scale by 1.25 or 0.8 in turn, and a translation by "
          "up to 1.7 each",
      .stage = "to world space",
      .right_answer =
          "the product is right to 100 gamma_4 |P||M| in double (Higham 3.5); the transform to "
          "world space and back gives the same point to 1e-6",
      .unit = "world unit",
      .oracle = Oracle::kExtended,
      .ours = {"products in double, inverse_affine", [] { return measure_error(in_double); }},
      .naive = {"products in float", [] { return measure_error(in_float); }},
      .mutants = {{"the factors are in the reverse order: leaf before root",
                   [] { return measure_error(from_the_leaf); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
