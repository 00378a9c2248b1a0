#include "study/extremes/cases/clip_case.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c34 {

Outcome measure_error(ClipFunction clips) {
  Random random(734);
  const std::vector<ClipPlane> planes = planes_without_far();
  // In NDC, coordinates are below 1.5/w, and w is at least 1/16 where it matters, so one rounding
  // error moves a point by less than 1.5 * 2 * 16 u = 48 u per coordinate (u is the unit roundoff,
  // 2^-24). An edge is cut by at most five planes, so the edges of the polygon move by up to 5 * 48
  // u sqrt(2), less than 340 u. Inside the NDC square the perimeter is at most 8, so twice the area
  // changes by less than 2 * 8 * 340 u.
  constexpr double kBound = 16 * 340 * 0x1p-24;
  WorstError worst;
  for (int signs = 0; signs < 8; ++signs) {
    for (int i = 0; i < 150; ++i) {
      std::array<Point<Clip>, 3> p;
      for (int k = 0; k < 3; ++k) {
        const bool behind = (signs >> k & 1) != 0;
        p[std::size_t(k)] = behind ? random_position(random, -1, 0) : random_position(random, 0, 1);
      }
      const ClipTriangle t = clip_corners(p[0], p[1], p[2]);
      const auto exact = exact::clip(exact::exact_polygon<exact::Rational>(t), planes);
      const bool too_near = std::any_of(
          exact.begin(), exact.end(), [](const auto& v) { return v.w < exact::Rational(0.0625); });
      if (too_near) continue;
      const Outline outline = clips(t, planes);
      const bool nothing_left = exact.empty() && outline.empty();
      worst.add(nothing_left ? 0 : area_error(outline, t, planes), kBound,
                fmt::format("signs of w {:03b}", signs));
    }
  }
  return worst.outcome(fmt::format("{} triangles", worst.count()));
}

// Tests |x| <= |w| instead of |x| <= w, which keeps the points behind the eye too.
Outline absolute_w(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  ClipTriangle mirrored = t;
  for (ClipVertex& v : mirrored) {
    if (v.position.w < 0) v.position.w = -v.position.w;
  }
  return pipeline_clips(mirrored, planes);
}
// Clips after the divide, with the frustum's sides but without the test w > 0. These planes alone
// also keep points behind the eye, which the divide mirrors.
Outline sides_after_divide(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  ClipTriangle divided = t;
  for (ClipVertex& v : divided) {
    Point<Clip>& p = v.position;
    p = {p.x / p.w, p.y / p.w, p.z / p.w, 1};
  }
  return pipeline_clips(divided, planes);
}

// Random triangles on both sides of the eye, each alone in a picture of 48 x 48 pixels.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    Random random(834);
    std::vector<RayCastReference> all;
    for (int i = 0; i < 96; ++i) {
      EyeTriangle t;
      for (std::size_t k = 0; k < 3; ++k) {
        const bool behind = (i >> k & 1) != 0;
        const double z = behind ? random.between(0, 6) : random.between(-6, -0.1);
        t[k] = {float(random.between(-4, 4)), float(random.between(-4, 4)), float(z)};
      }
      all.emplace_back(make_ray_scene({t}, PerspectiveLens{1.0, 0.5, 5.0}, 48));
    }
    // Then 400 small triangles on both sides of the near plane and of the far plane.
    std::vector<EyeTriangle> small;
    for (int i = 0; i < 400; ++i) {
      const double z = i % 2 == 0 ? -0.5 : -5, size = i % 2 == 0 ? 0.04 : 0.4;
      const auto around = [&](double middle) {
        return float(middle + random.between(-size, size));
      };
      const double x = random.between(0.6, -0.6) * -z, y = random.between(0.6, -0.6) * -z;
      small.push_back({Point<Eye>{around(x), around(y), around(z)},
                       {around(x), around(y), around(z)},
                       {around(x), around(y), around(z)}});
    }
    all.emplace_back(make_ray_scene(small, PerspectiveLens{1.0, 0.5, 5.0}, 192));
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c34

ExtremeCase c34_signs_of_w() {
  using namespace c34;
  return {
      .id = "C-34",
      .name = "All patterns of the signs of w",
      .construction = "150 random triangles for each of the eight patterns",
      .stage = "clip",
      .right_answer =
          "the clipped polygon has the rational area of the part inside the frustum, which is 0 if "
          "all w < 0",
      .unit = "twice NDC area",
      .oracle = Oracle::kRational,
      .ours = {"clip_triangle", [] { return measure_error(pipeline_clips); }},
      .naive = {"divide without clipping", [] { return measure_error(naive::nothing); }},
      .mutants = {{"clipping after the divide, without a test for w > 0",
                   [] { return measure_error(sides_after_divide); }},
                  {"|w| in place of w", [] { return measure_error(absolute_w); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
