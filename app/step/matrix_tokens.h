// The tokens of a printed matrix: numbers, names, and the marks between them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::app {

struct MatrixToken {
  enum class Kind { kNumber, kName, kMark };
  Kind kind;
  std::string_view text;
  int line = 1, column = 1;
  double value = 0;   // of a kNumber
  int digits = 0;     // significant digits as written; 0 for nan and inf
  int decimals = -1;  // after the point; -1 without a point, or with an exponent
};

// The tokens in the order of the text, without comments and blanks. Errors name the token and its
// place.
Result<std::vector<MatrixToken>> matrix_tokens(std::string_view text, const std::string& name);

}  // namespace glassbox::app
