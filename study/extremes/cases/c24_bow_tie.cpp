#include <glassbox/mesh/triangulate.h>
#include <algorithm>

#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/polygons.h"
#include "study/extremes/common/screen_scene.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c24 {

// Whether the tested code finds that the face has a normal, and so a front.
using HasNormal = bool (*)(const Polygon&);

Outcome measure_error(HasNormal has_normal) {
  const Polygon bow_ties[] = {
      {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
      {{5, 7, 1}, {6, 8, 1}, {6, 7, 1}, {5, 8, 1}},
      {{0, 0, 0}, {2, 2, 2}, {2, 0, 0}, {0, 2, 2}},
      // A figure in the shape of an 8 with six corners, and three corners on a line.
      {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}},
      {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}},
  };
  const Polygon square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  int wrong = has_normal(square) ? 0 : 1, all = 1;
  for (const Polygon& polygon : bow_ties) {
    const auto exact = exact_newell(polygon);
    const bool flat = exact.x.sign() == 0 && exact.y.sign() == 0 && exact.z.sign() == 0;
    wrong += has_normal(polygon) == flat;
    ++all;
  }
  return wrong_count_outcome(wrong, all, "faces get a wrong answer");
}

bool ours(const Polygon& polygon) {
  const Mesh mesh = mesh_of(polygon);
  return face_normal(mesh, mesh.faces[0]).has_value() && triangulate(mesh).degenerate_faces.empty();
}
bool is_not_zero(const Vector<Object, double>& m) {
  return m.x != 0 || m.y != 0 || m.z != 0;
}
bool by_first_corner(const Polygon& polygon) {
  return is_not_zero(naive::first_corner(polygon));
}
bool by_open_newell(const Polygon& polygon) {
  return is_not_zero(naive::open_newell(polygon));
}

// Each face alone in a picture: without a normal nothing is drawn, with a normal the face is
// visible.
Outcome measure_drawn_error(const TestedEngine& engine) {
  const Polygon faces[] = {{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
                           {{5, 7, 1}, {6, 8, 1}, {6, 7, 1}, {5, 8, 1}},
                           {{0, 0, 0}, {2, 2, 2}, {2, 0, 0}, {0, 2, 2}},
                           {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}},
                           {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}},
                           {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  Camera camera;
  camera.lens = OrthographicLens{9, 0, 20};
  camera.world_from_eye.at(2, 3) = 10;
  const View view = make_view(camera, 96, 96).value();
  int wrong = 0;
  for (const Polygon& face : faces) {
    const auto exact = exact_newell(face);
    const bool flat = exact.x.sign() == 0 && exact.y.sign() == 0 && exact.z.sign() == 0;
    const auto shown =
        engine.draw(scene_of(mesh_of(face), unlit_material()), view, plain_settings()).buffers.id;
    const bool leaves_trace =
        std::ranges::any_of(shown.pixels, [](std::uint32_t id) { return id != 0; });
    wrong += leaves_trace == flat;
  }
  return wrong_count_outcome(
      wrong, int(std::size(faces)),
      "faces are drawn although they have no normal, or are not drawn although they have one");
}

}  // namespace c24

ExtremeCase c24_bow_tie() {
  using namespace c24;
  return {
      .id = "C-24",
      .name = "Bow-ties",
      .construction = "three bow-ties, a figure of eight, three corners on a line, and a square",
      .stage = "face normals",
      .right_answer =
          "a face has no normal, and is reported, exactly if the rational Newell vector is zero",
      .unit = "faces",
      .oracle = Oracle::kRational,
      .ours = {"face_normal and triangulate", [] { return measure_error(ours); }},
      .naive = {"the cross product of the first three corners",
                [] { return measure_error(by_first_corner); }},
      .mutants = {{"the sums have an x in place of a y, or miss the last edge",
                   [] { return measure_error(by_open_newell); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
