// How each slip (a typical mistake with a convention) changes numbers. slips.h tries them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "labs/framework/lab.h"

namespace glassbox::labs {

// A typical mistake that undoes itself when it is made twice (a wrong sign or order). It is undone
// in the student's answer, so that a case's own judge can judge the result, too. `undo` returns the
// answer without the mistake: nothing if such a field cannot have the mistake, several answers if
// the mistake has several forms.
struct AnswerVariant {
  std::string slip;
  // How many different numbers the mistake must have changed before it is reported to the student.
  std::size_t evidence = 1;
  std::function<std::vector<std::vector<double>>(const Expected&, const std::vector<double>&)> undo;
};

// A typical mistake in an angle or in a product. It cannot be undone in the answer, so the expected
// numbers are computed with the mistake instead.
struct ExpectedVariant {
  std::string slip;
  std::function<std::vector<Expected>(const Expected&)> make;
};

// The mistake y = height - y' (y measured from the wrong side); the height follows from one wrong
// point.
AnswerVariant flipped_y_variant(double height);

std::vector<AnswerVariant> answer_variants();
std::vector<ExpectedVariant> expected_variants();

}  // namespace glassbox::labs
