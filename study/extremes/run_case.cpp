#include "study/extremes/run_case.h"

#include <algorithm>
#include <cctype>

namespace glassbox::study {

int CaseResult::mutants_caught() const {
  return int(std::ranges::count_if(mutants, [](const Outcome& each) { return !each.passes(); }));
}

int CaseResult::drawn_right() const {
  return int(std::ranges::count_if(drawn, &Outcome::passes));
}

bool CaseResult::holds() const {
  return ours_passes() && naive_fails() && mutants_caught() == int(mutants.size()) &&
         drawn_right() == int(drawn.size());
}

CaseResult run_case(const ExtremeCase& extreme) {
  CaseResult result{extreme, extreme.ours.measure_error(), extreme.naive.measure_error(), {}, {}};
  for (const Subject& mutant : extreme.mutants) result.mutants.push_back(mutant.measure_error());
  if (!extreme.drawn) return result;
  for (const TestedEngine& engine : tested_engines()) result.drawn.push_back(extreme.drawn(engine));
  return result;
}

const ExtremeCase* find_case(std::string_view id) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  const auto found = std::ranges::find_if(extreme_cases(), [&](const ExtremeCase& each) {
    return std::ranges::equal(each.id, id, same);
  });
  return found == extreme_cases().end() ? nullptr : &*found;
}

}  // namespace glassbox::study
