// Lab 3 in the chart of D-7: vertices before a camera far from the origin, by the student's view matrices, in double.
#include "labs/measuring/measuring.h"
#include "study/experiments/d07_field.h"

namespace glassbox::labs {

namespace {

using namespace study::d07;

constexpr int kFields = 32, kTimed = 1 << 9;  // as in a quick run

// The camera by its eye, what it looks at and what is up for it: the rows of its rotation.
Numbers question(bool by_rotations, const Field& field, Depth depth) {
  const glm::dmat3 world_from_eye = glm::transpose(study::rounded(field.eye_from_world));
  Numbers numbers{by_rotations ? 1.0 : 0.0};
  append_place(numbers, field.eye);
  append_place(numbers, field.eye - Vector<World, double>(world_from_eye[2] * kDistance));
  append_place(numbers, Vector<World, double>(world_from_eye[1]));
  append_matrix(numbers, projection(depth));
  for (const Point<World>& p : field.points) append_place(numbers, p);
  return numbers;
}

Result<double> rms_error(const Ask& ask, bool by_rotations, Depth depth, double offset) {
  std::vector<Field> fields;
  std::vector<Numbers> questions;
  for (int i = 0; i < kFields; ++i) {
    fields.push_back(make_field(std::uint64_t(i) + 1, offset, kPointsOfField));
    questions.push_back(question(by_rotations, fields.back(), depth));
  }
  const auto answers = ask(questions);
  if (!answers) return tl::unexpected(answers.error());
  double sum = 0;
  for (std::size_t i = 0; i < fields.size(); ++i)
    add_squared_errors(
        fields[i], depth, [&](std::size_t k) { return number_of((*answers)[i], k); }, sum);
  return rms_of(sum, depth, kFields);
}

std::vector<MeasuredPlace> places() {
  std::vector<MeasuredPlace> all;
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

}  // namespace

LabMeasure measured_03() {
  return {"D-7", "uvn_view, axis_angle_view", places};
}

}  // namespace glassbox::labs
