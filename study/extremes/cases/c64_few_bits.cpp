#include <glassbox/base/rounding.h>
#include "study/extremes/common/depth.h"
#include "study/extremes/common/extreme_case.h"

namespace glassbox::study {
namespace c64 {

// Predicts the smallest relative separation of two depths that a format can tell apart at a
// distance.
using Expected = double (*)(const DepthPath&, double distance, double step);

Outcome measure_error(Expected expected) {
  WorstError worst;
  for (const auto& [format, step] : {std::pair{DepthFormat::kUnorm16, 1 / 65535.0},
                                     std::pair{DepthFormat::kUnorm24, 1 / 16777215.0}}) {
    const DepthPath path{.format = format};
    for (const double distance : {1.0, 10.0, 100.0, 1000.0}) {
      const double really = standard_separation(distance, path.near, path.far, step);
      const double confused = coarsest_confused(path, distance, really);
      const double said = expected(path, distance, step);
      worst.add(std::max(confused / said, said / confused), 2,
                fmt::format("the smallest relative distance that is resolved is {:.2g} at the "
                            "distance {}, but {:.2g} is expected",
                            confused, distance, said));
    }
  }
  return worst.outcome();
}

double by_formula(const DepthPath& path, double distance, double step) {
  return standard_separation(distance, path.near, path.far, step);
}
// Assumes that the steps of depth are spread evenly over the distance between the planes.
double evenly(const DepthPath& path, double distance, double step) {
  return (path.far - path.near) * step / distance;
}
double without_near_plane(const DepthPath&, double distance, double step) {
  return distance * step;
}

// Rectangles at right angles to the gaze: compares the stored codes with the depth by the formula.
// In float, depth is (alpha z + beta)/z with rounded alpha and beta: its errors are 3 u |alpha|, 2
// u |beta|/z and 2 u of the quotient (u is the unit roundoff). Rounding to a code adds half a step.
Outcome measure_drawn_error(const TestedEngine& engine) {
  const double near = 0.1, far = 1e4;
  WorstError worst;
  for (const auto& [format, steps] :
       {std::pair{DepthFormat::kUnorm16, 65535.0}, {DepthFormat::kUnorm24, 16777215.0}}) {
    for (const float z : {0.125f, 1.0f, 10.0f, 100.0f, 1000.0f, 9000.0f}) {
      const double alpha = far / (far - near), beta = near * far / (far - near) / double(z);
      const double u = unit_roundoff<float>, depth = alpha - beta;
      const double bound = 0.5 + steps * u * (3 * alpha + 2 * beta + 2 * depth);
      worst.add(std::abs(double(pane_code_drawn(engine, near, far, format, z)) - depth * steps),
                bound, fmt::format("distance {:g}", z));
    }
  }
  return worst.outcome();
}

}  // namespace c64

ExtremeCase c64_few_bits() {
  using namespace c64;
  return {
      .id = "C-64",
      .name = "16 and 24 bits in a large scene",
      .construction = "near plane 0.1, far plane 10,000; pairs of surfaces at distances 1 to 1,000",
      .stage = "depth",
      .right_answer =
          "a step of depth is r = s z/(1 - s z) of the distance, s = 2^-b (1/n - 1/f), to a factor "
          "of two for the rounding of the depths themselves; this is 0.18 in 16 bits at 1,000",
      .unit = "times the expected value, or its inverse",
      .oracle = Oracle::kAnalytic,
      .ours = {"the formula", [] { return measure_error(by_formula); }},
      .naive = {"depth steps are taken as equally large between the planes",
                [] { return measure_error(evenly); }},
      .mutants = {{"the formula without the near plane",
                   [] { return measure_error(without_near_plane); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
