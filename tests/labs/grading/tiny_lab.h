// The judge of the tests' own lab: task 99.1 gives 4 points and task 99.2 gives 6, half of them for
// a hidden check.
#pragma once

#include <vector>

#include "labs/framework/lab.h"
#include "tests/labs/grading/tiny/99-tiny/cases.h"

namespace glassbox::test {

inline std::vector<labs::Case> tiny_cases(const std::vector<double>& inputs,
                                          double (*right)(double)) {
  std::vector<labs::Case> cases;
  for (const double x : inputs) {
    labs::Case each;
    each.where = "x = " + std::to_string(x);
    labs::Expected expected;
    expected.field = "y";
    expected.values = {right(x)};
    expected.bound = 1e-12;  // a thousand roundings of numbers up to 16
    each.expected = {expected};
    cases.push_back(each);
  }
  return cases;
}

inline const std::vector<labs::Lab>& tiny_labs() {
  static const std::vector<labs::Lab> labs{[] {
    labs::Lab lab;
    lab.number = 99;
    lab.folder = "99-tiny";
    lab.title = "Two functions";
    lab.tasks = {{"99.1", "Twice", 4}, {"99.2", "The reciprocal", 6}};
    lab.checks = {{"twice a number", "99.1", "world", false,
                   [] { return tiny_cases(inputs(), [](double x) { return 2 * x; }); }},
                  {"a reciprocal", "99.2", "world", false,
                   [] { return tiny_cases(inputs(), [](double x) { return 1 / x; }); }},
                  {"a reciprocal undone", "99.2", "world", true,
                   [] { return tiny_cases(hidden_inputs(), [](double x) { return x; }); }}};
    return lab;
  }()};
  return labs;
}

}  // namespace glassbox::test
