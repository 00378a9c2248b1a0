// The measured error beside the one that the theory predicts.
#pragma once

#include <optional>

#include "study/experiment/results.h"

namespace glassbox::study {

// A prediction is of the order of magnitude; more than a factor of two either way is a finding (SPEC D).
inline constexpr double kLeastRatio = 0.5, kGreatestRatio = 2;

struct TheoryCheck {
  // Measured over predicted; 1 where both are 0, infinite where only the prediction is.
  double ratio = 1;
  bool finding = false;  // outside [1/2, 2], or no number
};

// None where the theory says nothing.
std::optional<TheoryCheck> check_theory(const ConfigurationResult& result);

// A finding that the experiment does not explain: it has no reason, or one for another ratio.
bool is_unexplained(const ConfigurationResult& result);
int count_findings(const ExperimentResult& result);
int count_unexplained(const ExperimentResult& result);

}  // namespace glassbox::study
