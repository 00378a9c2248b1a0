// Cases put to their judges.
#pragma once

#include <string_view>
#include <vector>

#include "study/extremes/kit/extreme_case.h"

namespace glassbox::study {

struct CaseResult {
  const ExtremeCase& what;
  Outcome ours, naive;
  std::vector<Outcome> mutants;  // in the order of the case's
  std::vector<Outcome> drawn;    // in the order of the drawers; empty: does not show in a picture

  bool ours_passes() const { return ours.passes(); }
  bool naive_fails() const { return !naive.passes(); }
  int mutants_caught() const;
  int drawn_right() const;
  // All four as they should be. A mutant that passes its case is one that the case is no test for.
  bool holds() const;
};

// The case must outlive the result. The same to the last digit in every run.
CaseResult run(const ExtremeCase& extreme);

// By its id in either case, such as "C-38" or "c-38"; null: none.
const ExtremeCase* find_case(std::string_view id);

}  // namespace glassbox::study
