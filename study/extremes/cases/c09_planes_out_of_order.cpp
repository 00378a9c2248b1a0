#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/projection.h>

#include "exact/number.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/projection.h"

namespace glassbox::study {
namespace c09 {

using exact::Rational;
using Lens = Result<Transform<Clip, Eye>> (*)(double near, double far);

Outcome measure_error(Lens lens) {
  WorstError worst;
  for (const auto& [n, f] :
       {std::pair{1e-30, 1.0}, {1e-30, 1e30}, {1.0, std::nextafter(1.0, 2.0)}, {0.1, 100.0}}) {
    const auto m = lens(n, f);
    const Rational near(n), far(f);
    const Rational alpha = -far / (far - near), beta = -near * far / (far - near);
    const std::string where = fmt::format("near {:g}, far {:g}", n, f);
    // The bound is 4 ulps, each at most 2 u of the value (projection.h; u is the unit roundoff).
    constexpr double kBound = 8 * unit_roundoff<double>;
    worst.add(m ? exact::error_of(m->at(2, 2), alpha) / -double(alpha) : HUGE_VAL, kBound, where);
    worst.add(m ? exact::error_of(m->at(2, 3), beta) / -double(beta) : HUGE_VAL, kBound, where);
  }
  int accepted = 0;
  for (const auto& [n, f] :
       {std::pair{0.0, 1.0}, {-1.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}, {1.0, -1.0}}) {
    accepted += bool(lens(n, f));
  }
  if (accepted > 0) worst.add(HUGE_VAL, 0, "impossible near and far planes were accepted");
  return worst.outcome(fmt::format("{} of 5 impossible pairs of planes were accepted", accepted));
}

Result<Transform<Clip, Eye>> ours(double near, double far) {
  return perspective_degrees(90, 1, {near, far});
}
Result<Transform<Clip, Eye>> unchecked(double near, double far) {
  return naive::unchecked_perspective(90, 1, float(near), float(far));
}
Result<Transform<Clip, Eye>> equal_planes_pass(double near, double far) {
  if (near == far && near > 0) return unchecked(near, far);
  return ours(near, far);
}
Result<Transform<Clip, Eye>> swapped_when_out_of_order(double near, double far) {
  return far < near ? ours(far, near) : ours(near, far);
}

// Triangles between the near and far planes, none in front of another one: few steps of depth are
// left, so it would not be known which one is nearer.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    struct Planes {
      double near, far;
      float distance;
      DepthFormat format;
    };
    for (const Planes& planes : {Planes{1e-30, 1, 0.5f, DepthFormat::kFloat32},
                                 {1e-30, 1e30, 1e3f, DepthFormat::kFloat32},
                                 {1e-30, 1e10, 1e3f, DepthFormat::kFloat32Reversed},
                                 {1, 1 + 0x1p-20, 1 + 0x1p-21f, DepthFormat::kFloat32},
                                 {1, 1 + 0x1p-20, 1 + 0x1p-21f, DepthFormat::kUnorm24},
                                 {0.1, 100, 10, DepthFormat::kUnorm16}}) {
      const float d = planes.distance;
      std::vector<EyeTriangle> triangles{{Point<Eye>{-0.9f * d, -0.8f * d, -d},
                                          {0.9f * d, -0.8f * d, -d},
                                          {-0.9f * d, 0.6f * d, -d}},
                                         {Point<Eye>{0.9f * d, -0.6f * d, -d},
                                          {0.9f * d, 0.9f * d, -d},
                                          {-0.8f * d, 0.9f * d, -d}}};
      // Adds a triangle beyond the far plane, but only if the depth shows that: with n = 1e-30, 1 -
      // n/z is 1 in float on both sides of that plane.
      if (planes.near > 0x1p-24 || planes.format == DepthFormat::kFloat32Reversed) {
        const float z = -2 * float(planes.far);
        triangles.push_back({Point<Eye>{2 * z, 0, z}, {-2 * z, z, z}, {-2 * z, -z, z}});
      }
      RayScene ray_scene = make_ray_scene(
          triangles, PerspectiveLens{radians_from_degrees(90), planes.near, planes.far}, 48);
      store_depth(ray_scene, planes.format);
      all.emplace_back(std::move(ray_scene));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c09

ExtremeCase c09_planes_out_of_order() {
  using namespace c09;
  return {
      .id = "C-09",
      .name = "Near and far planes that make no sense, or hardly any",
      .construction =
          "near 1e-30, far 1 and 1e30; far the next double after near; then near = 0, negative, "
          "equal to and beyond far",
      .stage = "projection",
      .right_answer =
          "the entries of depth agree with the rational ones to 4 ulps; there is no matrix for "
          "planes in the wrong order",
      .unit = "of the entry",
      .oracle = Oracle::kRational,
      .ours = {"perspective_degrees", [] { return measure_error(ours); }},
      .naive = {"f / (f - n) in float, without any check", [] { return measure_error(unchecked); }},
      .mutants = {{"n = f is accepted", [] { return measure_error(equal_planes_pass); }},
                  {"for n > f the two planes are exchanged without an error",
                   [] { return measure_error(swapped_when_out_of_order); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
