// Text files with rows of numbers, such as matches and cameras.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::views {

struct NumberRow {
  std::uint64_t line = 0;  // from 1
  std::string name;        // the first word, if it is not a number
  std::vector<double> numbers;
};

// The whole word as a decimal number; none if it is not a number, or not finite.
std::optional<double> number_of(std::string_view word);

// A row for each line that is neither blank nor a comment ('#'). Words are separated by blanks,
// commas or semicolons. A word that is not a finite number is an error that names its line, unless
// it is the first word of the line.
Result<std::vector<NumberRow>> number_rows(std::string_view text);

}  // namespace glassbox::views
