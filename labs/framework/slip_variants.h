// The ways in which each convention slip changes numbers. slips.h tries them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "labs/framework/lab.h"

namespace glassbox::labs {

// A slip that undoes itself when it is made twice (a wrong sign or order) is undone in the answer;
// then a case's own judge can judge the changed answer. `undo` gives what the answer would be
// without the slip: an empty list where the slip cannot occur in such a field, several answers
// where it can be made in several ways.
struct AnswerVariant {
  std::string slip;
  // How many different numbers must have been changed before the slip is believed.
  std::size_t evidence = 1;
  std::function<std::vector<std::vector<double>>(const Expected&, const std::vector<double>&)> undo;
};

// A slip in an angle or in a product cannot be undone in the answer, so it is made in the expected
// numbers.
struct ExpectedVariant {
  std::string slip;
  std::function<std::vector<Expected>(const Expected&)> make;
};

// The slip y = height - y', with a height that follows from one wrong point.
AnswerVariant flipped_y_variant(double height);

std::vector<AnswerVariant> answer_variants();
std::vector<ExpectedVariant> expected_variants();

}  // namespace glassbox::labs
