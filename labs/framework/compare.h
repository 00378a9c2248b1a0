// Compares an answer with what is expected: finds the first place where they differ, and how.
//
// Everything is counted from 0, as in the code: rows, columns, vertices, pixels.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "labs/framework/lab.h"

namespace glassbox::labs {

// How many pixels are covered by fewer triangles than they should be (gaps), and how many by more
// (doubles). A pixel that should not be covered at all, but is, counts as extra.
struct CoverageCounts {
  std::size_t gaps = 0;
  std::size_t doubles = 0;
  std::size_t extra = 0;
};

struct Comparison {
  std::optional<Divergence> first;  // empty: the answer is right
  std::size_t differing = 0;        // numbers, vertices or pixels that are wrong or missing
  CoverageCounts coverage;          // only for Shape::kCoverage
  // only for Shape::kCoverage: the pixels around the first wrong pixel
  std::string map;
};

// Compares `actual` with `expected.values` according to the shape.
Comparison compare(const Expected& expected, const std::vector<double>& actual);

// Compares the answer's field of the same name with what is expected. A field that is not there
// counts as missing.
Comparison compare(const Expected& expected, const Answer& answer);

// The numbers of an answer's field; null if there is no field of that name.
const std::vector<double>* find_field(const Answer& answer, const std::string& name);

// Whether the answer has exactly these numbers in the field, each within the bound. It says what
// compare() says, for judges of generated inputs (GeneratedInputs::is_right).
bool has_numbers(const Answer& answer, const std::string& field, const std::vector<double>& right,
                 double bound = 0);

// The same for a field, and for several, each with its own bound or bounds.
bool has_field(const Answer& answer, const Expected& right);
bool has_fields(const Answer& answer, const std::vector<Expected>& right);

// Judges numbers by others that were computed in double and are at most half of the bound away from
// the exact ones: an answer within half of the bound of them is right, and one that is more than
// twice the bound away is wrong. Between the two only exact numbers tell, and nothing is returned.
// `actual` is null if the answer has no such field.
std::optional<bool> judge_nearly(const Expected& nearly, const std::vector<double>* actual);
inline std::optional<bool> judge_nearly(const std::vector<double>& nearly, double bound,
                                        const std::vector<double>* actual) {
  return judge_nearly(numbers("", nearly, bound), actual);
}
inline std::optional<bool> judge_nearly(const Expected& nearly, const Answer& answer) {
  return judge_nearly(nearly, find_field(answer, nearly.field));
}

// How many columns an expected matrix has, numbers a vertex of a polygon, or pixels a row of a
// coverage; 0 for other shapes.
int columns_of(const Expected& expected);

// The name of a number of the field: "row 2, column 3", "vertex 4, w", "pixel (10, 12)".
std::string element_name(const Expected& expected, std::size_t index);

// |expected - actual|: 0 for equal infinities and for two NaN, infinity if only one of the two
// numbers is NaN.
double distance_between(double expected, double actual);

// The name of a kind: "missing", "extra", "wrong position", "wrong data", "not a number".
const char* kind_name(Divergence::Kind kind);

}  // namespace glassbox::labs
