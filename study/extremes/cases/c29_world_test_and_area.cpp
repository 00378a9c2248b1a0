#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/back_face.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>

#include <glassbox/base/random.h>
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c29 {

// Whether a face is culled before anything is transformed. If the value of the facing test is
// smaller than `margin`, snapping may reverse the winding of the face.
using CullTest = bool (*)(std::span<const Point<Object>>, const ObjectViewer&, double margin);

Outcome measure_error(CullTest culls) {
  Random random(729);
  const Viewport viewport{0, 0, 640, 480};
  const auto lens = perspective_degrees(90, 640.0 / 480, {1, 20}).value();
  int lost = 0, culled = 0, all = 0;
  for (int i = 0; i < 20000; ++i) {
    const double distance = random.between(3, 8), turn = random.between(0, 360);
    const auto eye_from_object = translate<Eye, Eye>({0, 0, -distance}) *
                                 rotate_degrees<Eye, Object>({1, 2, 0.5}, turn).value();
    const Transform<Clip, Object> exact = lens * eye_from_object;
    const auto clip_from_object = round_to_float(exact);
    const auto viewer = viewer_in_object_space(eye_from_object, true);
    if (!viewer) continue;

    // Sizes go down to slivers of a hundredth of a pixel, where snapping may exchange front and
    // back.
    const double size = std::ldexp(1.0, -int(random.integer(0, 12)));
    const Vector<Object, double> centre{random.between(-0.5, 0.5), random.between(-0.5, 0.5), 0};
    std::array<Point<Object>, 3> face;
    std::array<SnappedVertex, 3> snapped;
    double largest_w = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = centre.x + size * random.between(-1, 1);
      const double y = centre.y + size * random.between(-1, 1);
      face[k] = {float(x), float(y), float(size * random.between(-1, 1))};
      const Point<Clip> p = clip_from_object * face[k];
      largest_w = std::max(largest_w, double(p.w));
      snapped[k] = snap(to_screen(divide(p), viewport));
    }
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const SnappedVertex &a = snapped[k], &b = snapped[(k + 1) % 3];
      longest =
          std::max({longest, (std::abs(a.x - b.x) + 2) / 256.0, (std::abs(a.y - b.y) + 2) / 256.0});
    }
    // Snapping moves a vertex by up to 2^-9 px. Before that, matrix and transform have errors of 5
    // u (u is the unit roundoff, 2^-24) of numbers below 16; the quotient multiplies the error by
    // at most 2/w < 2, and the viewport by 320: together less than 2^-8 px.
    const double margin =
        snapping_margin(exact, *viewer, viewport, largest_w, longest, 0x1p-9 + 0x1p-8);
    if (!culls(face, *viewer, margin)) continue;
    ++culled;
    // A face that is counter-clockwise on the screen has a negative area and is a front face: it
    // would have been drawn.
    lost += double_area(snapped[0], snapped[1], snapped[2]) < 0;
    ++all;
  }
  // The tested code must not pass by culling nothing: about half of the 20000 faces are back faces.
  if (culled < 5000) return must_be_zero(HUGE_VAL, "fewer than 5,000 triangles were culled");
  return wrong_count_outcome(lost, all, "of the culled faces would have been drawn as front faces");
}

bool ours(std::span<const Point<Object>> face, const ObjectViewer& viewer, double margin) {
  return certainly_back(test_back_face(face, viewer), margin);
}
bool any_back_in_float(std::span<const Point<Object>> face, const ObjectViewer& viewer, double) {
  return naive::facing<float>(face, viewer) == Facing::kBack;
}
bool exact_but_no_margin(std::span<const Point<Object>> face, const ObjectViewer& viewer, double) {
  return certainly_back(test_back_face(face, viewer), 0);
}

// Slivers that are one or two snapping steps wide, so that snapping may reverse their winding.
// Slivers that are certainly back faces are culled before snapping; for all others, the area after
// snapping decides.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<CoverageReference> pictures = [] {
    Random random(829);
    std::vector<ScreenTriangle> slivers;
    for (int i = 0; i < 2000; ++i) {
      const double x = random.between(0, 250), y = random.between(0, 250);
      const double dx = random.between(-8, 8), dy = random.between(-8, 8), t = random.unit();
      const double right = random.between(-1, 1) / 512, down = random.between(-1, 1) / 512;
      slivers.push_back({screen_vertex(x, y), screen_vertex(x + dx, y + dy),
                         screen_vertex(x + t * dx + right, y + t * dy + down)});
    }
    std::vector<CoverageReference> all;
    for (const Cull cull : {Cull::kBack, Cull::kFront}) {
      for (const CullStage stage : {CullStage::kScreen, CullStage::kObject}) {
        all.emplace_back(slivers, 256, Culling{cull, stage});
      }
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c29

ExtremeCase c29_world_test_and_area() {
  using namespace c29;
  return {
      .id = "C-29",
      .name = "The test in space against the area on the screen",
      .construction = "20000 random triangles of 1 .. 2^-12 units, 3 .. 8 away, in 640 x 480 px",
      .stage = "back faces",
      .right_answer =
          "no face is culled whose snapped triangle would be drawn as a front face: the test in "
          "space keeps a margin for the snap",
      .unit = "faces",
      .oracle = Oracle::kInteger,
      .ours = {"certainly_back with snapping_margin", [] { return measure_error(ours); }},
      .naive = {"(P - eye) . m > 0 in float", [] { return measure_error(any_back_in_float); }},
      .mutants = {{"the test leaves no margin for the snap",
                   [] { return measure_error(exact_but_no_margin); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
