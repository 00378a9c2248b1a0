// The words of a printed matrix: numbers, names, and what stands between them.
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
  double value = 0;   // kNumber
  int digits = 0;     // significant ones, as written; 0 for nan and inf
  int decimals = -1;  // after the point; -1 without a point, or with an exponent
};

// In the order of the text. Comments and blanks are left out. Errors name the token and its place.
Result<std::vector<MatrixToken>> matrix_tokens(std::string_view text, const std::string& name);

}  // namespace glassbox::app
