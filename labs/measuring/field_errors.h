// The error that labs are measured by in experiment D-7 (one or two matrices for view and
// projection): that of the depths of vertices in front of a camera far from the origin.
#pragma once

#include <vector>

#include "labs/measuring/measuring.h"
#include "study/experiments/d07_field.h"

namespace glassbox::labs {

// The error in a quick run: over 32 fields (sets of points) at the distance `offset` from the
// origin. `question_of(field)` makes the question for the depths of a field's points.
template <class QuestionOf>
Result<double> rms_field_error(const Ask& ask, const QuestionOf& question_of,
                               study::d07::Depth depth, double offset) {
  using namespace study::d07;
  constexpr int kFields = 32;
  std::vector<Field> fields;
  std::vector<Numbers> questions;
  for (int i = 0; i < kFields; ++i) {
    fields.push_back(make_field(std::uint64_t(i) + 1, offset, kPointsOfField));
    questions.push_back(question_of(fields.back()));
  }
  const auto answers = ask(questions);
  if (!answers) return tl::unexpected(answers.error());
  double sum = 0;
  for (std::size_t i = 0; i < fields.size(); ++i)
    add_squared_errors(
        fields[i], depth, [&](std::size_t k) { return number_of((*answers)[i], k); }, sum);
  return rms_of(sum, depth, kFields);
}

}  // namespace glassbox::labs
