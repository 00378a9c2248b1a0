// Compares the measured error with the one that the theory predicts.
#pragma once

#include <optional>

#include "study/experiment/results.h"

namespace glassbox::study {

// A prediction gives only the order of magnitude; a measured error that differs by more than a
// factor of two is a finding.
inline constexpr double kMinRatio = 0.5, kGreatestRatio = 2;

struct TheoryCheck {
  // measured / predicted; 1 if both are 0, infinite if only the prediction is 0.
  double ratio = 1;
  bool finding = false;  // the ratio is outside [1/2, 2], or NaN
};

// None if the theory predicts nothing.
std::optional<TheoryCheck> check_theory(const ConfigurationResult& result);

// Whether there is a finding that the experiment does not explain: it gives no reason, or a reason
// for another range of ratios.
bool is_unexplained(const ConfigurationResult& result);
int count_findings(const ExperimentResult& result);
int count_unexplained(const ExperimentResult& result);

}  // namespace glassbox::study
