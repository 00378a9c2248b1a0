#include "labs/framework/batch.h"

#include <algorithm>

#include "labs/framework/compare.h"
#include "labs/framework/varied_inputs.h"

namespace glassbox::labs {

namespace {

// The numbers of one field, with where the next answer begins.
struct FieldReader {
  const Answer::Field& values;
  const std::vector<double>& sizes;
  std::size_t at = 0;

  // How many numbers answer number i has; -1 if it has no such field.
  double size(std::size_t i) const { return sizes.size() == 1 ? sizes[0] : sizes[i]; }
  std::vector<double> next(std::size_t count) {
    const auto first = values.values.begin() + std::ptrdiff_t(at);
    at += count;
    return {first, first + std::ptrdiff_t(count)};
  }
};

// Whether the sizes are those of so many answers, and their sum is that of the numbers.
bool fits(const FieldReader& field, std::size_t inputs) {
  if (field.sizes.size() != 1 && field.sizes.size() != inputs) return false;
  double sum = 0;
  for (std::size_t i = 0; i < inputs; ++i) {
    if (!(field.size(i) >= -1) || field.size(i) > double(field.values.values.size())) return false;
    sum += std::max(0.0, field.size(i));
  }
  return sum == double(field.values.values.size());
}

bool is_sizes(const std::string& name) {
  return name.ends_with(kSizes);
}

}  // namespace

std::optional<std::vector<Answer>> split_batch(const Answer& batch, std::size_t inputs) {
  std::vector<FieldReader> fields;
  for (const Answer::Field& field : batch.fields()) {
    if (is_sizes(field.name)) continue;
    const auto* sizes = find_field(batch, field.name + kSizes);
    if (sizes == nullptr) return std::nullopt;
    fields.push_back({field, *sizes});
    if (!fits(fields.back(), inputs) || fields.size() * inputs > kMaxSplitFields)
      return std::nullopt;
  }
  std::vector<Answer> answers(inputs);
  for (std::size_t i = 0; i < inputs; ++i) {
    for (FieldReader& field : fields) {
      if (field.size(i) >= 0)
        answers[i].emit(field.values.name, field.next(std::size_t(field.size(i))));
    }
  }
  return answers;
}

std::vector<std::uint64_t> choices_of(const GeneratedInputs& inputs, std::size_t index) {
  Choices choices(input_seed(inputs_seed(), inputs.what, int(index)));
  inputs.make(choices);
  return choices.made();
}

std::vector<std::size_t> wrong_inputs(const GeneratedInputs& inputs,
                                      const std::vector<Answer>& answers) {
  std::vector<std::size_t> wrong;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    Choices choices(input_seed(inputs_seed(), inputs.what, int(i)));
    if (!inputs.is_right(choices, answers[i])) wrong.push_back(i);
  }
  return wrong;
}

}  // namespace glassbox::labs
