#include <glassbox/mesh/triangulate.h>

#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/polygons.h"
#include "study/extremes/common/screen_scene.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c25 {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;  // indices of positions
using Cut = Triangles (*)(const Mesh&);

const Polygon kPositions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};

struct RepeatingFace {
  std::vector<std::uint32_t> face;
  double area;
};

Outcome measure_error(Cut cut) {
  // Faces with repeated indices, with a repeated position (4 is at the same place as 1), with two
  // corners, and with one.
  const RepeatingFace faces[] = {{{0, 1, 1}, 0},      {{0, 1, 4}, 0},   {{0, 0, 0}, 0},
                                 {{0, 1}, 0},         {{2}, 0},         {{0, 1, 1, 2, 3}, 1},
                                 {{0, 1, 4, 2}, 0.5}, {{0, 1, 2, 3}, 1}};
  int wrong = 0, all = 0;
  for (const RepeatingFace& repeating : faces) {
    const Triangles triangles = cut(mesh_of(kPositions, repeating.face));
    double area = 0;
    bool sound = true;
    for (const auto& t : triangles) {
      const std::array<Point<Object>, 3> p{kPositions[t[0]], kPositions[t[1]], kPositions[t[2]]};
      const auto m = newell_vector<float>(std::span<const Point<Object>>(p));
      const double twice = std::sqrt(double(dot(m, m)));
      sound = sound && twice > 0;  // a triangle without area has the normal 0/0
      area += twice / 2;
    }
    wrong += !sound || area != repeating.area;
    ++all;
  }
  return wrong_count_outcome(wrong, all, "faces are triangulated wrongly");
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

// Drops triangles that use an index twice, but not those with two indices at the same position.
Triangles by_index_alone(const Mesh& mesh) {
  Triangles kept;
  for (const auto& t : fan(mesh)) {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) kept.push_back(t);
  }
  return kept;
}

// Whether a point of the unit square is inside the face.
using Inside = bool (*)(double x, double y);

struct FaceOutline {
  std::vector<std::uint32_t> face;
  Inside inside;
};

// Each face alone, half-transparent, with 16 px per unit: every pixel must be covered as often as
// its centre is inside the face. Pixels with centres on the diagonal of the square are not checked,
// because they are exactly on an edge of one of the faces.
Outcome measure_drawn_error(const TestedEngine& engine) {
  const Inside nowhere = [](double, double) { return false; };
  const Inside everywhere = [](double, double) { return true; };
  const Inside below = [](double x, double y) { return y < x; };
  const FaceOutline faces[] = {{{0, 1, 1}, nowhere},  {{0, 1, 4}, nowhere},
                               {{0, 0, 0}, nowhere},  {{0, 1}, nowhere},
                               {{2}, nowhere},        {{0, 1, 1, 2, 3}, everywhere},
                               {{0, 1, 4, 2}, below}, {{0, 1, 2, 3}, everywhere}};
  Camera camera;
  camera.lens = OrthographicLens{2, 0, 2};
  camera.world_from_eye.at(2, 3) = 1;
  const View view = make_view(camera, 64, 64).value();
  int wrong = 0, all = 0;
  for (const FaceOutline& shown : faces) {
    const Scene scene = scene_of(mesh_of(kPositions, shown.face), layer_material());
    const auto picture = engine.draw(scene, view, plain_settings()).buffers.color;
    for (int row = 0; row < 64; ++row) {
      for (int column = 0; column < 64; ++column) {
        const double x = (column + 0.5 - 32) / 16, y = (32 - row - 0.5) / 16;
        if (x == y) continue;
        const bool in_square = x > 0 && x < 1 && y > 0 && y < 1;
        wrong += layers_of(picture.at(column, row)) != int(in_square && shown.inside(x, y));
        ++all;
      }
    }
  }
  return wrong_count_outcome(wrong, all, "pixels are covered too often or not often enough");
}

}  // namespace c25

ExtremeCase c25_repeated_corners() {
  using namespace c25;
  return {
      .id = "C-25",
      .name = "Repeated corners",
      .construction =
          "eight faces with repeated indices, repeated positions, only two corners or only one",
      .stage = "triangulation",
      .right_answer = "all triangles have an area, and together they have the area of the face",
      .unit = "faces",
      .oracle = Oracle::kAnalytic,
      .ours = {"triangulate", [] { return measure_error(ours); }},
      .naive = {"a fan from the first corner", [] { return measure_error(fan); }},
      .mutants = {{"repeated corners are recognised only by their index",
                   [] { return measure_error(by_index_alone); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
