// Measures lab 4 for the chart of the experiment on one or two matrices for view and projection
// (D-7): vertices in front of a camera far from the origin are transformed by the student's
// projection and divide, in double.
#include "labs/measuring/field_errors.h"
#include "study/experiments/d07_field.h"

#include <glassbox/base/trig.h>

namespace glassbox::labs {

namespace lab_04_measured {

using namespace study::d07;

constexpr int kTimed = 1 << 9;  // as in a quick run of the experiment

Numbers question(const Field& field, Depth depth) {
  Numbers numbers{depth == Depth::kReversedInfinite ? 1.0 : 0.0, kPi / 2, 1, kNear,
                  planes(depth).far};
  append_matrix(numbers, view_of(field));
  for (const Point<World>& p : field.points) append_point(numbers, p);
  return numbers;
}

Result<double> rms_error(const Ask& ask, Depth depth, double offset) {
  return rms_field_error(
      ask, [&](const Field& field) { return question(field, depth); }, depth, offset);
}

std::vector<MeasuredPoint> measured_points() {
  std::vector<MeasuredPoint> all;
  for (const Depth depth : {Depth::kStandard, Depth::kReversedInfinite}) {
    for (const double offset : {1e2, 1e3, 1e4, 1e5, 1e6})
      all.push_back({"yours", offset, name_of(depth), "",
                     [=](const Ask& ask) { return rms_error(ask, depth, offset); },
                     question(make_field(1, offset, kTimed), depth), double(kTimed)});
  }
  return all;
}

}  // namespace lab_04_measured

LabMeasure measured_04() {
  using namespace lab_04_measured;
  return {"D-7", "perspective, in_dialect, divide", measured_points};
}

}  // namespace glassbox::labs
