// The input of a stage (drawing.h), in words: what each number of the record is.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "labs/framework/stages.h"

namespace glassbox::labs {

// In place of how many: up to the end of the record; as many as the record's next number says.
inline constexpr int kAllThatFollow = -1, kCounted = -2;

// A part of a record.
struct InputPart {
  std::string name;  // "corner"
  // How many numbers belong together: three are a point, sixteen a matrix of 4 x 4, twelve one of
  // 3 x 4, nine one of 3 x 3 (all row by row). May be kCounted.
  int columns = 1;
  int count = 1;  // how often the part is repeated. May be kAllThatFollow or kCounted.
  // What the part means if it is 0, 1, ...: "left eye", "right eye". Empty: a number is a number.
  std::vector<std::string> meanings = {};
};

// Returns a function that writes a record as words: "eye (0, 2, 4), corner 0 (1, 0, 0), corner 1
// ...". Repeated parts are numbered from 0. At most twelve of them are written, and how many more
// there are.
std::function<std::string(const Numbers& input)> in_words(std::vector<InputPart> parts);

}  // namespace glassbox::labs
