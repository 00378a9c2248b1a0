#include "study/extremes/cases/clip_case.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c35 {

bool repeats_a_vertex(const Outline& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (outline[i] == outline[(i + 1) % outline.size()]) return true;
  }
  return false;
}

Outcome measure_error(ClipFunction clips) {
  Random random(735);
  const auto planes = frustum_planes();
  // The same bound as in c34_signs_of_w.cpp. Here w is at least 1 and the coordinates are below 2,
  // so there is room for the far plane as the sixth plane.
  constexpr double kBound = 16 * 340 * 0x1p-24;
  int wrong = 0, repeated = 0;
  constexpr int kTriangles = 1500;
  for (int i = 0; i < kTriangles; ++i) {
    const auto position = [&] {
      const float x = float(random.integer(-4, 4)) / 2, y = float(random.integer(-4, 4)) / 2;
      const float z = float(random.integer(-2, 4)) / 2;
      return Point<Clip>{x, y, z, float(random.integer(1, 2))};
    };
    const Point<Clip> a = position(), b = position();
    const ClipTriangle t = clip_corners(a, b, position());
    const Outline outline = clips(t, planes);
    const bool repeats = outline.size() > 0 && repeats_a_vertex(outline);
    repeated += repeats;
    wrong += repeats || outline.size() > 9 || outline.size() == 1 || outline.size() == 2 ||
             !(area_error(outline, t, planes) <= kBound);
  }
  return wrong_count_outcome(wrong, kTriangles, "polygons are wrong",
                             fmt::format("; {} of them have repeated vertices", repeated));
}

Outline on_the_plane_is_outside(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  return naive::clip({.on_plane_is_inside = false}, t, planes);
}
// The right code without its last step, which removes vertices that repeat the one before.
Outline repetitions_kept(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  std::vector<ClipStep> steps;
  clip_triangle(t, planes, &steps);
  Outline outline;
  const ClipPolygon& last = steps.back().after;
  for (int i = 0; i < last.count; ++i) {
    outline.push_back(last.vertices[std::size_t(i)].position);
  }
  return outline;
}

// Triangles with corners exactly on the near or far plane, where z = 0 or w = z exactly, and at the
// edges of the picture.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    const OrthographicLens lens{2, 1, 3};
    const Point<Eye> corners[] = {{-2, -2, -1}, {2, -2, -1}, {2, 2, -3},  {-2, 2, -3},
                                  {0, -2, -3},  {2, 0, -1},  {-1, 1, -2}, {0, 3, -1},
                                  {-3, -3, -3}, {1, 0, -4},  {0, 1, 0}};
    Random random(835);
    for (int i = 0; i < 24; ++i) {
      const auto corner = [&] { return corners[random.integer(0, 10)]; };
      all.emplace_back(make_ray_scene({{corner(), corner(), corner()}}, lens, 32));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c35

ExtremeCase c35_on_the_planes() {
  using namespace c35;
  return {
      .id = "C-35",
      .name = "Vertices exactly on the planes",
      .construction = "1500 triangles on a lattice of halves that reaches beyond the frustum",
      .stage = "clip",
      .right_answer =
          "the clipped polygon has the rational area, at most nine vertices, no vertex twice, and "
          "never one or two vertices",
      .unit = "polygons",
      .oracle = Oracle::kRational,
      .ours = {"clip_triangle", [] { return measure_error(pipeline_clips); }},
      .naive = {"a vertex on a plane counts as outside",
                [] { return measure_error(on_the_plane_is_outside); }},
      .mutants = {{"repeated vertices are kept", [] { return measure_error(repetitions_kept); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
