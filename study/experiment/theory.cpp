#include "study/experiment/theory.h"

#include <algorithm>

namespace glassbox::study {

std::optional<TheoryCheck> check_theory(const ConfigurationResult& result) {
  if (!result.predicted_error) return std::nullopt;
  const double predicted = *result.predicted_error;
  TheoryCheck check;
  check.ratio = result.error == predicted ? 1 : result.error / predicted;
  check.finding = !(check.ratio >= kMinRatio && check.ratio <= kGreatestRatio);
  return check;
}

bool is_unexplained(const ConfigurationResult& result) {
  const auto check = check_theory(result);
  return check && check->finding &&
         !(result.explanation && result.explanation->explains(check->ratio));
}

int count_findings(const ExperimentResult& result) {
  return int(std::ranges::count_if(result.configurations, [](const ConfigurationResult& each) {
    const auto check = check_theory(each);
    return check && check->finding;
  }));
}

int count_unexplained(const ExperimentResult& result) {
  return int(std::ranges::count_if(result.configurations, is_unexplained));
}

}  // namespace glassbox::study
