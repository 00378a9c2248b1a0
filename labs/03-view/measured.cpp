// Measures lab 3 for the chart of the experiment on one or two matrices for view and projection
// (D-7): vertices in front of a camera far from the origin are transformed by the student's view
// matrices, in double.
#include "labs/measuring/field_errors.h"
#include "study/experiments/d07_field.h"

namespace glassbox::labs {

namespace lab_03_measured {

using namespace study::d07;

constexpr int kTimed = 1 << 9;  // as in a quick run of the experiment

// The camera's eye, the point it looks at and its up direction, made from the rows of its rotation.
Numbers question(bool by_rotations, const Field& field, Depth depth) {
  const glm::dmat3 world_from_eye = glm::transpose(study::rounded(field.eye_from_world));
  Numbers numbers{by_rotations ? 1.0 : 0.0};
  append_point(numbers, field.eye);
  append_point(numbers, field.eye - Vector<World, double>(world_from_eye[2] * kDistance));
  append_point(numbers, Vector<World, double>(world_from_eye[1]));
  append_matrix(numbers, projection(depth));
  for (const Point<World>& p : field.points) append_point(numbers, p);
  return numbers;
}

Result<double> rms_error(const Ask& ask, bool by_rotations, Depth depth, double offset) {
  return rms_field_error(
      ask, [&](const Field& field) { return question(by_rotations, field, depth); }, depth, offset);
}

std::vector<MeasuredPoint> measured_points() {
  std::vector<MeasuredPoint> all;
  for (const bool by_rotations : {false, true}) {
    for (const Depth depth : {Depth::kStandard, Depth::kReversedInfinite}) {
      for (const double offset : {1e2, 1e3, 1e4, 1e5, 1e6}) {
        all.push_back(
            {by_rotations ? "yours, two rotations" : "yours, U V N", offset, name_of(depth), "",
             [=](const Ask& ask) { return rms_error(ask, by_rotations, depth, offset); },
             question(by_rotations, make_field(1, offset, kTimed), depth), double(kTimed)});
      }
    }
  }
  return all;
}

}  // namespace lab_03_measured

LabMeasure measured_03() {
  using namespace lab_03_measured;
  return {"D-7", "uvn_view, axis_angle_view", measured_points};
}

}  // namespace glassbox::labs
