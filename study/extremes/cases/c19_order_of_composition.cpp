#include <glassbox/pipeline/affine.h>
#include <utility>

#include "exact/matrix.h"
#include "exact/number.h"
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/extremes/common/screen_scene.h"
#include "study/naive/transform.h"

namespace glassbox::study {
namespace c19 {

using exact::Rational;
// Returns the matrix that turns the object about its own origin first, then moves it.
using ComposeModelMatrix = glm::dmat4 (*)(const WorldMap& turn, const WorldMap& move);

Outcome measure_error(ComposeModelMatrix place) {
  WorstError worst;
  for (const double degrees : {90.0, 180.0, 270.0}) {  // their matrices have exact entries
    const WorldMap turn = rotate_degrees<World>(WorldVector(0, 0, 1), degrees).value();
    const WorldVector offset{3, -5, 8};
    const glm::dmat4 m = place(turn, translate<World>(offset));
    for (const WorldPoint& p : {WorldPoint(0, 0, 0), WorldPoint(1, 2, 3), WorldPoint(-4, 0, 7)}) {
      const auto turned = exact::exactly<Rational>(turn) * exact::exactly<Rational>(p);
      const Rational exact[] = {turned[0] + Rational(3), turned[1] - Rational(5),
                                turned[2] + Rational(8)};
      const WorldPoint placed = WorldMap(m) * p;
      const double found[] = {placed.x, placed.y, placed.z};
      for (std::size_t k = 0; k < 3; ++k) {
        worst.add(exact::error_of(found[k], exact[k]), 0, fmt::format("{} degrees", degrees));
      }
    }
  }
  return worst.outcome();
}

glm::dmat4 translation_last(const WorldMap& turn, const WorldMap& move) {
  return (move * turn).columns;
}
glm::dmat4 in_reading_order(const WorldMap& turn, const WorldMap& move) {
  return (turn * move).columns;
}
glm::dmat4 premultiplied(const WorldMap& turn, const WorldMap& move) {
  return naive::premultiplied(move.columns, turn.columns);
}
glm::dmat4 transposed_storage(const WorldMap& turn, const WorldMap& move) {
  return (move * WorldMap(glm::transpose(turn.columns))).columns;
}

// A triangle that is turned and moved, compared with its exact place in whole numbers: T R p
// (translation, rotation, point) minus the place of the eye.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    const std::array<Point<Object>, 3> corners{Point<Object>{-2, -1, 0}, {3, -1, 0}, {1, 2, 1}};
    for (int quarter = 1; quarter <= 3; ++quarter) {
      const WorldMap turn = rotate_degrees<World>(WorldVector(0, 0, 1), 90.0 * quarter).value();
      const WorldVector offset{3, -5, 8};
      Mesh mesh;
      add_triangle(mesh, corners);
      Scene scene = scene_of(std::move(mesh), unlit_material());
      scene.nodes[0].world_from_node = translate<World>(offset) * turn * Transform<World, Object>();
      RayScene ray_scene =
          make_ray_scene(scene, camera_at(WorldPoint{3, -5, 15}, {0, 0, -1}), 64, 64);
      ray_scene.triangles.clear();
      ExactEyeTriangle& seen = ray_scene.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        long double x = corners[k].x, y = corners[k].y;
        for (int i = 0; i < quarter; ++i) x = std::exchange(y, x) * -1;
        seen.corners[k] = {x, y, static_cast<long double>(corners[k].z) - 7};
      }
      all.emplace_back(std::move(ray_scene));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c19

ExtremeCase c19_order_of_composition() {
  using namespace c19;
  return {
      .id = "C-19",
      .name = "The order of composition",
      .construction = "turns by 90, 180 and 270 degrees and a move by (3, -5, 8)",
      .stage = "to world space",
      .right_answer = "the matrix is exactly T R; R T differs from it by (R - I) a",
      .unit = "world unit",
      .oracle = Oracle::kRational,
      .ours = {"translate * rotate", [] { return measure_error(translation_last); }},
      .naive = {"the factors in reading order: rotate * translate",
                [] { return measure_error(in_reading_order); }},
      .mutants = {{"each factor is put on the wrong side of the product",
                   [] { return measure_error(premultiplied); }},
                  {"the rotation is transposed", [] { return measure_error(transposed_storage); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
