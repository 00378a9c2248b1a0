#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/projection.h>

#include "exact/number.h"
#include "study/extremes/common/depth.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/projection.h"

namespace glassbox::study {
namespace c10 {

using exact::Rational;

struct Planes {
  double near, far;
};
// Computes the depth as it is stored, in float: 1 at the near plane, 0 at the far plane.
using ReversedDepth = float (*)(const Planes&, float distance);

// The distance that belongs to a reversed depth d: n f / (n + d (f - n)) for planes at n and f, and
// n/d for an infinite far plane.
Rational distance_of(const Planes& planes, float depth) {
  const Rational n(planes.near), d(static_cast<double>(depth));
  if (std::isinf(planes.far)) return n / d;
  const Rational f(planes.far);
  return n * f / (n + d * (f - n));
}

Outcome measure_error(ReversedDepth depth) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  WorstError worst;
  for (const double far : {100.0, 1e5, 1e8, kInfinity}) {
    const Planes planes{0.125, far};
    for (double z = 0.15; z < std::min(far, 1e7) * 0.9; z *= 1.37) {
      const float distance = float(z);
      const float d = depth(planes, distance);
      const Rational exact(static_cast<double>(distance));
      const double error = d > 0 ? double(abs(distance_of(planes, d) - exact) / exact) : kInfinity;
      // Two rounded entries, a product, a sum and a quotient: each has an error of up to u (the
      // unit roundoff) of the two terms n/z and n/f of the depth, together 5 u (n/z + n/f). The
      // distance changes by z (f - n)/(f n) times that, as a fraction of z: less than 5 u (1 +
      // z/f).
      const double bound = 5 * unit_roundoff<float> * (1 + z / far) * (1 + 0x1p-20);
      worst.add(error, bound, fmt::format("far {:g}, distance {:.4g}", far, z), 1 + z / far);
    }
  }
  return worst.outcome();
}

float clip_space_depth(const Planes& planes, float distance, DepthRange range) {
  const auto lens = perspective_degrees(90, 1, {planes.near, planes.far, range}).value();
  return divide(round_to_float(lens) * Point<Eye>(0, 0, -distance)).position.z;
}
float ours(const Planes& planes, float distance) {
  return clip_space_depth(planes, distance, DepthRange::kReversed);
}
float standard(const Planes& planes, float distance) {
  const double n = planes.near;
  const float far = std::isinf(planes.far) ? 1e30f : float(planes.far);
  const auto lens = round_to_float(naive::unchecked_perspective(90, 1, float(n), far));
  return naive::depth_reversed_afterwards(lens * Point<Eye>(0, 0, -distance));
}
float one_minus_standard(const Planes& planes, float distance) {
  return 1 - clip_space_depth(planes, distance, DepthRange::kStandard);
}
float through_gl(const Planes& planes, float distance) {
  const auto lens =
      perspective_degrees(90, 1, {planes.near, planes.far, DepthRange::kReversed}).value();
  return naive::depth_through_gl_remap(round_to_float(lens) * Point<Eye>(0, 0, -distance));
}

// Rectangles at right angles to the gaze, and the depths that a run stores for them. All vertices
// of a rectangle have the same depth, so interpolation adds no rounding error.
Outcome measure_drawn_error(const TestedEngine& engine) {
  WorstError worst;
  for (const double far : {100.0, 1e5, 1e8, double(HUGE_VAL)}) {
    for (float z = 0.15f; z < 1e7f && double(z) < far; z *= 4) {
      const double n = 0.125;
      const auto code = pane_code_drawn(engine, n, far, DepthFormat::kFloat32Reversed, z);
      const double depth = depth_of_reversed_code(code), share = std::isinf(far) ? 0 : n / far;
      // With share = n/f: depth = (n/z - share) / (1 - share), so z = n / (depth (1 - share) +
      // share).
      const double recovered = n / (depth * (1 - share) + share);
      const double condition = 1 + (std::isinf(far) ? 0 : double(z) / far);
      worst.add(std::abs(recovered / double(z) - 1),
                5 * unit_roundoff<float> * condition * (1 + 0x1p-20),
                fmt::format("far {:g}, distance {:.4g}", far, z));
    }
  }
  return worst.outcome();
}

}  // namespace c10

ExtremeCase c10_depth_ratio() {
  using namespace c10;
  return {
      .id = "C-10",
      .name = "Far over near from 1000 to infinity",
      .construction =
          "near plane 1/8, far plane 100, 1e5, 1e8 and infinity; distances 0.15 .. 1e7, each 1.37 "
          "times the one before; each distance is computed back from the stored depth",
      .stage = "projection",
      .right_answer =
          "the distance is right to 5 u (1 + z/f), because reversed float depth keeps its digits "
          "(B.3)",
      .unit = "of the distance",
      .oracle = Oracle::kRational,
      .ours = {"reversed depth from the matrix", [] { return measure_error(ours); }},
      .naive = {"f / (f - n) in float", [] { return measure_error(standard); }},
      .mutants = {{"depth is reversed as 1 - depth",
                   [] { return measure_error(one_minus_standard); }},
                  {"reversed z through OpenGL's [-1, 1]",
                   [] { return measure_error(through_gl); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
