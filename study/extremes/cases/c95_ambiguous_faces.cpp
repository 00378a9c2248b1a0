#include <functional>

#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "study/naive/polygons.h"
#include "views/polygons/mesh_check.h"

namespace glassbox::study {
namespace c95 {

using views::PolygonMesh;
using views::ScalarField;
using Surface = std::function<PolygonMesh(const ScalarField& field)>;

// Two cells that share a face with two opposite corners inside: one cell has only those two corners
// inside, the other has all corners inside but two.
ScalarField beside_its_opposite() {
  ScalarField field(2, 2, 3, -1);
  field.at(0, 0, 1) = field.at(1, 1, 1) = 1;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) field.at(x, y, 2) = 1;
  }
  return field;
}

Outcome measure_error(const Surface& surface) {
  std::int64_t wrong = 0, edges = 0, odd = 0;
  const auto see = [&](const ScalarField& field) {
    const views::MeshCheck check = views::check_mesh(surface(field));
    wrong += check.holes + check.non_manifold_edges + check.misoriented_edges;
    odd += check.euler % 2 != 0;
    edges += check.edges;
  };
  see(beside_its_opposite());
  Random random(95);
  for (int i = 0; i < 400; ++i) {
    ScalarField field(4, 4, 4);
    for (double& value : field.values) value = random.between(-1, 1);
    see(field);
  }
  return must_be_zero(double(wrong + odd),
                      fmt::format("{} of {} edges are not shared by two triangles that pass them "
                                  "in opposite directions; the Euler number is odd {} times",
                                  wrong, edges, odd));
}

Outcome measure_table_error(const views::CellTable& table) {
  return measure_error(
      [&](const ScalarField& field) { return views::polygonise_with(table, field, 0); });
}

}  // namespace c95

ExtremeCase c95_ambiguous_faces() {
  using namespace c95;
  return {
      .id = "C-95",
      .name = "Faces that can be cut in two ways",
      .construction =
          "two cells that share a face with two opposite corners inside, where one cell has two "
          "corners inside and the other six; 400 random fields of 4 x 4 x 4",
      .stage = "polygons",
      .right_answer =
          "the surface is closed: each edge is in exactly two triangles, and V - E + F is even "
          "(S1-39)",
      .unit = "edges",
      .oracle = Oracle::kProperty,
      .ours = {"one rule for every ambiguous face",
               [] {
                 return measure_error([](const ScalarField& field) {
                   return views::polygonise(field, 0, views::Polygoniser::kConsistent);
                 });
               }},
      .naive = {"the table of fifteen cases",
                [] { return measure_table_error(views::naive_table()); }},
      .mutants =
          {{"the triangles of complementary cases are not reversed",
            [] { return measure_table_error(naive::table_of_opposites_not_turned()); }},
           {"one rule for the faces at low coordinates, another for those at high coordinates",
            [] { return measure_table_error(naive::table_by_sides()); }},
           {"polygons are cut into fans whose diagonals lie on the cell's faces",
            [] { return measure_table_error(naive::table_of_fans()); }}},
      .not_drawn = "views/polygons makes the surface; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
