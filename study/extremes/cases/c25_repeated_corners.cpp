#include <glassbox/mesh/triangulate.h>

#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/polygons.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c25 {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;  // indices of positions
using Cut = Triangles (*)(const Mesh&);

const Polygon kPositions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};

struct Repeating {
  std::vector<std::uint32_t> face;
  double area;
};

Outcome judge(Cut cut) {
  // Repeated indices, a repeated position (4 lies where 1 does), two corners, one.
  const Repeating faces[] = {{{0, 1, 1}, 0},      {{0, 1, 4}, 0},   {{0, 0, 0}, 0},
                             {{0, 1}, 0},         {{2}, 0},         {{0, 1, 1, 2, 3}, 1},
                             {{0, 1, 4, 2}, 0.5}, {{0, 1, 2, 3}, 1}};
  int wrong = 0, all = 0;
  for (const Repeating& repeating : faces) {
    const Triangles triangles = cut(mesh_of(kPositions, repeating.face));
    double area = 0;
    bool sound = true;
    for (const auto& t : triangles) {
      const std::array<Point<Object>, 3> p{kPositions[t[0]], kPositions[t[1]], kPositions[t[2]]};
      const auto m = newell_vector<float>(std::span<const Point<Object>>(p));
      const double twice = std::sqrt(double(dot(m, m)));
      sound = sound && twice > 0;  // a triangle without area has 0/0 for its normal
      area += twice / 2;
    }
    wrong += !sound || area != repeating.area;
    ++all;
  }
  return wrong_of(wrong, all, "faces cut wrongly");
}

Triangles ours(const Mesh& mesh) {
  Triangles triangles;
  for (const Triangle& t : triangulate(mesh).triangles) {
    std::array<std::uint32_t, 3> positions;
    for (std::size_t k = 0; k < 3; ++k) positions[k] = mesh.corners[t.corners[k]].position;
    triangles.push_back(positions);
  }
  return triangles;
}

Triangles fan(const Mesh& mesh) {
  Triangles triangles;
  for (std::size_t i = 2; i < mesh.corners.size(); ++i) {
    triangles.push_back(
        {mesh.corners[0].position, mesh.corners[i - 1].position, mesh.corners[i].position});
  }
  return triangles;
}

// Drops triangles that name a position twice, but not those whose positions coincide.
Triangles by_index_alone(const Mesh& mesh) {
  Triangles kept;
  for (const auto& t : fan(mesh)) {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) kept.push_back(t);
  }
  return kept;
}

}  // namespace c25

ExtremeCase c25_repeated_corners() {
  using namespace c25;
  return {
      .id = "C-25",
      .name = "Repeated corners",
      .construction = "eight faces with repeated indices, repeated positions, two corners, one",
      .stage = "triangulation",
      .right = "triangles with area only, and the whole area of the face",
      .unit = "faces",
      .oracle = Oracle::kAnalytic,
      .ours = {"triangulate", [] { return judge(ours); }},
      .naive = {"a fan from the first corner", [] { return judge(fan); }},
      .mutants = {{"repetitions found by index alone", [] { return judge(by_index_alone); }}},
  };
}

}  // namespace glassbox::study
