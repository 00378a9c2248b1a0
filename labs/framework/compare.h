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
