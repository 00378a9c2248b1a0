// The ways in which each convention slip changes numbers. slips.h tries them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "labs/framework/lab.h"

namespace glassbox::labs {

// A slip that undoes itself when it is made once more (a sign, an order) is undone in the answer, so that a case with a judge of
// its own can be asked again. `undo` gives what the answer would be without the slip: none where the slip does not
// apply to such a field, several where it may have been made in several ways.
struct AnswerVariant {
  std::string slip;
  // Different numbers that must be changed before the slip is believed.
  std::size_t evidence = 1;
  std::function<std::vector<std::vector<double>>(const Expected&, const std::vector<double>&)> undo;
};

// A slip in an angle or in a product is made in what is expected.
struct ExpectedVariant {
  std::string slip;
  std::function<std::vector<Expected>(const Expected&)> make;
};

// y = height - y' with a height that follows from one wrong point.
AnswerVariant y_from_other_end(double height);

std::vector<AnswerVariant> answer_variants();
std::vector<ExpectedVariant> expected_variants();

}  // namespace glassbox::labs
