#include "study/extremes/cases/clip_case.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

#include <glassbox/base/trig.h>

namespace glassbox::study {
namespace c38 {

Outcome measure_error(ClipFunction clips) {
  Random random(738);
  const std::vector<ClipPlane> near{frustum_planes()[0]};
  int mismatches = 0, edges = 0;
  double apart = 0;
  constexpr int kPairs = 50000;
  for (int i = 0; i < kPairs; ++i) {
    // The edge from a to b is shared by two triangles. Its end a is in front of the near plane and
    // b behind it. The third corners c and d are inside, on either side of the edge.
    const auto coordinate = [&] { return float(random.between(-10, 10)); };
    const float ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
    const Point<Clip> a{ax, ay, float(random.between(0.1, 10)), float(random.between(1, 10))};
    const Point<Clip> b{bx, by, float(random.between(-10, -0.1)), float(random.between(-1, 10))};
    const Point<Clip> c{1, 2, 3, 4}, d{-1, -2, 3, 4};
    // The crossing of the edge with the plane is the second vertex of the first outline, and must
    // also be a vertex of the other outline.
    const Outline one = clips(clip_corners(a, b, c), near);
    const Outline other = clips(clip_corners(b, a, d), near);
    ++edges;
    if (one.size() < 2 || other.empty()) {
      ++mismatches;
      continue;
    }
    const Point<Clip> crossing = one[1];
    if (std::find(other.begin(), other.end(), crossing) != other.end()) continue;
    ++mismatches;
    double nearest = HUGE_VAL;
    for (const Point<Clip>& p : other) {
      nearest = std::min(nearest, std::max(std::abs(double(p.x) - double(crossing.x)),
                                           std::abs(double(p.y) - double(crossing.y))));
    }
    apart = std::max(apart, nearest);
  }
  const std::string how_far =
      fmt::format(" ({:.1f} %), up to {:.2g} apart", 100.0 * mismatches / edges, apart);
  return wrong_count_outcome(mismatches, edges, "shared edges were cut at two different places",
                             mismatches > 0 ? how_far : "");
}

Outline asymmetric(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  return naive::clip({}, t, planes);
}
Outline one_minus_t(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  return naive::clip({.crossing = naive::weighted_by_t}, t, planes);
}
// Computes t in double, where it is practically exact, and then rounds it to float: 1 - t is then
// not the t of the same crossing measured from the other end.
Outline t_in_double(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  const auto crossing = [](const Point<Clip>& a, float d_a, const Point<Clip>& b, float d_b) {
    const double s = double(d_a) / (double(d_a) - double(d_b));
    const float rounded = float(s);
    return naive::mixed(a, b, 1 - rounded, rounded);
  };
  return naive::clip({.crossing = crossing}, t, planes);
}

// Cones of 400 triangles around the line of sight that extend behind the eye. The near plane cuts
// every shared edge, and the whole picture is inside the cone, so every pixel must be covered once.
Outcome measure_drawn_error(const TestedEngine& engine) {
  Watertightness all;
  for (std::uint64_t seed = 838; seed < 858; ++seed) {
    Random random(seed);
    const auto aside = [&] { return float(random.between(-0.1, 0.1)); };
    const Point<Eye> hub{aside(), aside(), -3};
    std::vector<Point<Eye>> rim;
    for (int i = 0; i < 400; ++i) {
      const SinCos turn = sin_cos_degrees(0.9 * (i + random.between(0, 0.9)));
      rim.push_back({float(10 * turn.cos), float(10 * turn.sin), 5});
    }
    std::vector<EyeTriangle> triangles;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      triangles.push_back({hub, rim[i], rim[(i + 1) % rim.size()]});
    }
    RayScene cone = make_ray_scene(triangles, PerspectiveLens{1.8, 1.0, 40.0}, 128);
    cone.scene.materials = {layer_material()};
    const auto colors = engine.draw(cone.scene, cone.view, cone.settings).buffers.color;
    Image<int> times(colors.width, colors.height);
    std::ranges::transform(colors.pixels, times.pixels.begin(), layers_of);
    all.add(times);
  }
  return all.outcome();
}

}  // namespace c38

ExtremeCase c38_shared_clipped_edge() {
  using namespace c38;
  return {
      .id = "C-38",
      .name = "A shared edge, clipped",
      .construction =
          "50000 edges through the near plane, each shared by two triangles that pass it in "
          "opposite directions",
      .stage = "clip",
      .right_answer =
          "both triangles cut the edge at the same point, bit for bit, by the formula (A |dB| + B "
          "|dA|) / (|dA| + |dB|) (B.1)",
      .unit = "edges",
      .oracle = Oracle::kInteger,
      .ours = {"clip_triangle", [] { return measure_error(pipeline_clips); }},
      .naive = {"a + t (b - a)", [] { return measure_error(asymmetric); }},
      .mutants = {{"(1 - t) a + t b", [] { return measure_error(one_minus_t); }},
                  {"t is computed in double, then rounded",
                   [] { return measure_error(t_in_double); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
