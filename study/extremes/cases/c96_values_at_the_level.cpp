#include <functional>

#include <glassbox/base/random.h>

#include "study/extremes/kit/extreme_case.h"
#include "study/naive/polygons.h"
#include "views/polygons/mesh_check.h"

namespace glassbox::study {
namespace c96 {

using views::PolygonMesh;
using views::ScalarField;
using Surface = std::function<PolygonMesh(const ScalarField& field, double level)>;

Outcome judge(const Surface& surface) {
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
    open += check.holes + check.crowded + check.turned;
    pinched += check.pinched;
    triangles += std::int64_t(mesh.polygons.size());
  }
  return must_be_zero(double(degenerate + duplicates + open + pinched),
                      fmt::format("of {} triangles {} without area; {} corners at another one's "
                                  "place, {} pinched; {} edges not of two triangles",
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
      .right =
          "no triangle without area, no corner twice, and closed: a value at the level is an "
          "infinitely small step above it, and corners keep off the lattice's",
      .unit = "triangles, corners and edges",
      .oracle = Oracle::kProperty,
      .ours = {"decided as if perturbed", [] { return judge(ours); }},
      .naive = {"placed where the value is the level",
                [] {
                  return judge([](const ScalarField& field, double level) {
                    return naive::placed_exactly(ours(field, level), field, level);
                  });
                }},
      .mutants = {{"the level moved by 1e-17, which rounding takes back",
                   [] {
                     return judge([](const ScalarField& field, double level) {
                       return naive::placed_exactly(ours(field, level), field, level - 1e-17);
                     });
                   }},
                  {"corners in one place made one",
                   [] {
                     return judge([](const ScalarField& field, double level) {
                       return naive::welded(
                           naive::placed_exactly(ours(field, level), field, level));
                     });
                   }}},
      .not_drawn = "surfaces are made by views/polygons; no engine takes part",
  };
}

}  // namespace glassbox::study
