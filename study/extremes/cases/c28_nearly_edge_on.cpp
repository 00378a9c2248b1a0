#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/back_face.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/polygons.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c28 {

using exact::Rational;

struct Answer {
  Facing facing = Facing::kFront;
  bool exactly = false;  // whether the exact sum was needed
};
using FacingTest = Answer (*)(std::span<const Point<Object>>, const ObjectViewer&);

int exact_sign(std::span<const Point<Object>> face, const ObjectViewer& viewer) {
  using V = Vector<Object, Rational>;
  const Vector<Object, double>& e = viewer.eye_or_gaze;
  const V sight(Rational(double(face[0].x)) - Rational(e.x),
                Rational(double(face[0].y)) - Rational(e.y),
                Rational(double(face[0].z)) - Rational(e.z));
  return dot(sight, exact_newell(face)).sign();
}

Outcome measure_error(FacingTest facing) {
  Random random(728);
  int wrong = 0, all = 0, exact = 0;
  for (const double sine : {1e-3, 1e-5, 1e-8, 1e-13, 0.0}) {
    for (int i = 0; i < 300; ++i) {
      std::array<Point<Object>, 3> face;
      for (Point<Object>& p : face) {
        const double x = random.between(-1, 1), y = random.between(-1, 1);
        p = {float(x), float(y), float(random.between(-1, 1))};
      }
      // A point at 10^4 times the edge's length along an edge, and off the triangle's plane by
      // about the given sine.
      const auto along = [&](float a, float b) {
        return double(a) + 1e4 * (double(b) - double(a)) + 1e4 * sine * random.between(-1, 1);
      };
      const double x = along(face[0].x, face[1].x), y = along(face[0].y, face[1].y);
      const ObjectViewer viewer{true, {x, y, along(face[0].z, face[1].z)}, {0, 0, 0}};
      const Answer answer = facing(face, viewer);
      const int sign = answer.facing == Facing::kBack    ? 1
                       : answer.facing == Facing::kFront ? -1
                                                         : 0;
      wrong += sign != exact_sign(face, viewer);
      exact += answer.exactly;
      ++all;
    }
  }
  return wrong_count_outcome(wrong, all, "signs are wrong",
                             fmt::format("; {} were decided by the exact sum", exact));
}

Answer ours(std::span<const Point<Object>> face, const ObjectViewer& viewer) {
  const BackFaceTest test = test_back_face(face, viewer);
  return {test.facing, test.used_exact};
}
Answer in_float(std::span<const Point<Object>> face, const ObjectViewer& viewer) {
  return {naive::facing<float>(face, viewer), false};
}
Answer in_double(std::span<const Point<Object>> face, const ObjectViewer& viewer) {
  return {naive::facing<double>(face, viewer), false};
}

// Large triangles of which little is visible: two corners are at random places, the third is a few
// pixels away from the line through them, and their distances differ. Front faces or back faces are
// culled, at both stages where culling can be done.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    Random random(828);
    std::vector<EyeTriangle> triangles;
    for (int i = 0; i < 120; ++i) {
      const auto anywhere = [&] { return random.between(-0.9, 0.9); };
      const double x0 = anywhere(), y0 = anywhere(), x1 = anywhere(), y1 = anywhere();
      const double share = random.between(0.2, 0.8), off = random.between(-4, 4) / 48;
      const double x[] = {x0, x1, x0 + share * (x1 - x0) + off * (y1 - y0)};
      const double y[] = {y0, y1, y0 + share * (y1 - y0) - off * (x1 - x0)};
      EyeTriangle t;
      for (std::size_t k = 0; k < 3; ++k) {
        const double w = random.between(1, 30);
        t[k] = {float(x[k] * w), float(y[k] * w), float(-w)};
      }
      triangles.push_back(t);
    }
    std::vector<RayCastReference> all;
    for (const Cull cull : {Cull::kBack, Cull::kFront}) {
      for (const CullStage stage : {CullStage::kScreen, CullStage::kObject}) {
        RayScene ray_scene =
            make_ray_scene(triangles, PerspectiveLens{radians_from_degrees(90), 0.5, 40.0}, 96);
        ray_scene.settings.cull = cull;
        ray_scene.settings.cull_stage = stage;
        all.emplace_back(std::move(ray_scene));
      }
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c28

ExtremeCase c28_nearly_edge_on() {
  using namespace c28;
  return {
      .id = "C-28",
      .name = "Faces that are nearly edge-on",
      .construction = "1500 random triangles seen from 10^4 away at sines of 1e-3 .. 1e-13 and 0",
      .stage = "back faces",
      .right_answer = "the sign is that of rational arithmetic",
      .unit = "signs",
      .oracle = Oracle::kRational,
      .ours = {"test_back_face", [] { return measure_error(ours); }},
      .naive = {"(P - eye) . m in float", [] { return measure_error(in_float); }},
      .mutants = {{"in double, without the exact sum", [] { return measure_error(in_double); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
