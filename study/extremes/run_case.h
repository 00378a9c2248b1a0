// Runs the extreme cases.
#pragma once

#include <string_view>
#include <vector>

#include "study/extremes/common/extreme_case.h"

namespace glassbox::study {

struct CaseResult {
  const ExtremeCase& extreme_case;
  Outcome ours, naive;
  std::vector<Outcome> mutants;  // in the order of the case
  // The results for complete pictures, in the order of the engines; empty if the case does not show
  // in a picture.
  std::vector<Outcome> drawn;

  bool ours_passes() const { return ours.passes(); }
  bool naive_fails() const { return !naive.passes(); }
  int mutants_caught() const;
  int drawn_right() const;
  // Whether our code passes, the naive code fails, every mutant fails and all drawn results are
  // right. A mutant that passes means that the case does not test for it.
  bool holds() const;
};

// Runs a case, which must outlive the result. Every run gives the same result to the last digit.
CaseResult run_case(const ExtremeCase& extreme);

// Finds a case by its id, such as "C-38" or "c-38"; null if there is none.
const ExtremeCase* find_case(std::string_view id);

}  // namespace glassbox::study
