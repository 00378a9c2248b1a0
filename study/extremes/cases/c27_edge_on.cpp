#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/back_face.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c27 {

using FacingTest = Facing (*)(std::span<const Point<Object>>, const ObjectViewer&);

Outcome measure_error(FacingTest facing) {
  Random random(727);
  int wrong = 0, culled = 0;
  constexpr int kFaces = 2000;
  for (int i = 0; i < kFaces; ++i) {
    // The corners are integers times 2^-10. The eye is a combination of the corners with integer
    // factors, so it is exactly in their plane.
    std::array<Point<Object>, 3> face;
    for (Point<Object>& p : face) {
      const auto coordinate = [&] { return float(random.integer(-(1 << 20), 1 << 20)) * 0x1p-10f; };
      const float x = coordinate(), y = coordinate();
      p = {x, y, coordinate()};
    }
    const double s = double(random.integer(-99, 99)), t = double(random.integer(-99, 99));
    const auto in_plane = [&](float a, float b, float c) {
      return double(a) + s * (double(b) - double(a)) + t * (double(c) - double(a));
    };
    const ObjectViewer viewer{
        true,
        {in_plane(face[0].x, face[1].x, face[2].x), in_plane(face[0].y, face[1].y, face[2].y),
         in_plane(face[0].z, face[1].z, face[2].z)},
        {0, 0, 0}};
    const Facing found = facing(face, viewer);
    wrong += found != Facing::kEdgeOn;
    culled += found == Facing::kBack;
  }
  return wrong_count_outcome(wrong, kFaces, "edge-on faces were classified wrongly",
                             fmt::format("; {} were culled", culled));
}

Facing ours(std::span<const Point<Object>> face, const ObjectViewer& viewer) {
  return test_back_face(face, viewer).facing;
}
// Uses the sign of the value computed in floating point, without the exact sum that is computed if
// this value is near zero.
Facing without_fallback(std::span<const Point<Object>> face, const ObjectViewer& viewer) {
  const double value = test_back_face(face, viewer).value;
  return value > 0 ? Facing::kBack : value < 0 ? Facing::kFront : Facing::kEdgeOn;
}

// Triangles in front of a wall, with the eye in their plane. Their corners have coordinates that
// floats hold exactly, and are seen at whole pixels on one line of the screen, so that nothing is
// rounded and no pixel is covered. Drawn with every kind of culling, at both stages where culling
// can be done.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    Random random(827);
    std::vector<EyeTriangle> triangles;
    for (int i = 0; i < 80; ++i) {
      const auto place = [&](double low, double high) {
        return float(random.integer(std::int64_t(low), std::int64_t(high)));
      };
      const float x = place(-24, 24), y = place(-24, 24), dx = place(-4, 4), dy = place(-4, 4);
      EyeTriangle t;
      for (std::size_t k = 0; k < 3; ++k) {
        const float steps = place(-2, 2), w = float(1 << random.integer(0, 2));
        t[k] = {(x + dx * steps) / 32 * w, (y + dy * steps) / 32 * w, -w};
      }
      // The corners of a triangle are collinear on the screen, but must not be collinear in space,
      // because three such points are no triangle.
      const Vector<Eye> a = t[1] - t[0], b = t[2] - t[0];
      const auto [nx, ny, nz] =
          std::array{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
      if (nx != 0 || ny != 0 || nz != 0) triangles.push_back(t);
    }
    triangles.push_back({Point<Eye>{-20, -20, -8}, {40, -20, -8}, {-20, 40, -8}});
    std::vector<RayCastReference> all;
    for (const Cull cull : {Cull::kNone, Cull::kBack, Cull::kFront}) {
      for (const CullStage stage : {CullStage::kScreen, CullStage::kObject}) {
        RayScene ray_scene =
            make_ray_scene(triangles, PerspectiveLens{radians_from_degrees(90), 0.5, 16.0}, 64);
        ray_scene.settings.cull = cull;
        ray_scene.settings.cull_stage = stage;
        all.emplace_back(std::move(ray_scene));
      }
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c27

ExtremeCase c27_edge_on() {
  using namespace c27;
  return {
      .id = "C-27",
      .name = "An eye in the face's plane",
      .construction =
          "2000 triangles of integers times 2^-10, the eye an integer combination of their corners",
      .stage = "back faces",
      .right_answer =
          "the face is found to be exactly edge-on; it counts as a front face and covers no pixel",
      .unit = "faces",
      .oracle = Oracle::kRational,
      .ours = {"test_back_face", [] { return measure_error(ours); }},
      .naive = {"(P - eye) . m in float", [] { return measure_error(naive::facing<float>); }},
      .mutants = {{"the exact sum is not computed where rounding errors may decide",
                   [] { return measure_error(without_fallback); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
