#include <functional>

#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "study/naive/polygons.h"
#include "views/polygons/mesh_check.h"

namespace glassbox::study {
namespace c96 {

using views::PolygonMesh;
using views::ScalarField;
using Surface = std::function<PolygonMesh(const ScalarField& field, double level)>;

Outcome measure_error(const Surface& surface) {
  std::int64_t degenerate = 0, duplicates = 0, open = 0, triangles = 0, pinched = 0;
  Random random(96);
  for (int i = 0; i < 300; ++i) {
    ScalarField field(4, 4, 4);
    for (double& value : field.values) value = double(random.integer(-2, 2));
    const double level = double(random.integer(-1, 1));
    const PolygonMesh mesh = surface(field, level);
    const views::MeshCheck check = views::check_mesh(mesh);
    degenerate += check.degenerate;
    duplicates += check.duplicates;
    open += check.holes + check.non_manifold_edges + check.misoriented_edges;
    pinched += check.pinched;
    triangles += std::int64_t(mesh.polygons.size());
  }
  return must_be_zero(
      double(degenerate + duplicates + open + pinched),
      fmt::format("{} triangles, {} of them without area; {} corners are at the place of another, "
                  "{} join separate parts of the surface; {} edges are not in two triangles",
                  triangles, degenerate, duplicates, pinched, open));
}

PolygonMesh ours(const ScalarField& field, double level) {
  return views::polygonise(field, level, views::Polygoniser::kConsistent);
}

}  // namespace c96

ExtremeCase c96_values_at_the_level() {
  using namespace c96;
  return {
      .id = "C-96",
      .name = "Corners at the level itself",
      .construction = "300 fields of 4 x 4 x 4 whole numbers from -2 to 2, cut at -1, 0 or 1",
      .stage = "polygons",
      .right_answer =
          "no triangle is without area, no corner occurs twice, and the surface is closed, because "
          "a value at the level counts as slightly above it, and corners are never exactly on the "
          "lattice's corners",
      .unit = "triangles, corners and edges",
      .oracle = Oracle::kProperty,
      .ours = {"a value equal to the level counts as above it", [] { return measure_error(ours); }},
      .naive = {"corners are placed exactly where the value is the level",
                [] {
                  return measure_error([](const ScalarField& field, double level) {
                    return naive::placed_exactly(ours(field, level), field, level);
                  });
                }},
      .mutants = {{"the level moved by 1e-17, which rounding undoes",
                   [] {
                     return measure_error([](const ScalarField& field, double level) {
                       return naive::placed_exactly(ours(field, level), field, level - 1e-17);
                     });
                   }},
                  {"corners at the same place are merged",
                   [] {
                     return measure_error([](const ScalarField& field, double level) {
                       return naive::welded(
                           naive::placed_exactly(ours(field, level), field, level));
                     });
                   }}},
      .not_drawn = "views/polygons makes the surface; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
