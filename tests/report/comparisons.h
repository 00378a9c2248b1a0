// Comparisons made by hand, as input for the reports.
#pragma once

#include <string>
#include <utility>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox::test {

inline Comparison comparison(const std::string& name, Verdict verdict) {
  Comparison result;
  result.name = name;
  result.verdict = verdict;
  result.reference = {"ref/" + name, 8, 4, "RGB", "8 bits"};
  result.test = {"out/" + name, 8, 4, "RGB", "8 bits"};
  result.differences = Differences{};
  result.differences->compared = 32;
  return result;
}

// A comparison with three wrong pixels in two regions.
inline Comparison different(const std::string& name) {
  Comparison result = comparison(name, Verdict::kDifferent);
  Differences& found = *result.differences;
  found.differing = 3;
  found.largest = 9;
  found.first = {2, 1};
  found.box = {2, 1, 5, 3};
  found.region_count = 2;
  found.regions = {{{2, 1, 2, 1}, 2, 9, {3, 1}}, {{6, 3, 1, 1}, 1, 4, {6, 3}}};
  result.reasons = {"3 of 32 pixels differ"};
  return result;
}

inline Comparison without_test(const std::string& name) {
  Comparison result;
  result.name = name;
  result.verdict = Verdict::kMissing;
  result.reference.path = "ref/" + name;
  result.test.path = "out/" + name;
  result.error = Error{"out/" + name, "", "there is no such picture", "render it"};
  return result;
}

inline Comparison broken(const std::string& name) {
  Comparison result = without_test(name);
  result.verdict = Verdict::kUncompared;
  result.error = Error{"out/" + name, "chunk 3", "is cut off", "save it again"};
  return result;
}

inline Comparison without_reference(const std::string& name) {
  Comparison result = without_test(name);
  result.verdict = Verdict::kNew;
  result.error = Error{"ref/" + name, "", "there is no such reference", "look at it"};
  return result;
}

}  // namespace glassbox::test
