// An answer against what is expected: the first place where they differ, and how.
//
// Everything is counted from 0, as in the code: rows, columns, vertices, pixels.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "labs/framework/lab.h"

namespace glassbox::labs {

// Pixels of a coverage that are covered less often than they should be, and more often. A pixel that nothing should
// cover is extra when something does.
struct CoverageCounts {
  std::size_t gaps = 0;
  std::size_t doubles = 0;
  std::size_t extra = 0;
};

struct Comparison {
  std::optional<Divergence> first;  // none: right
  std::size_t differing = 0;        // numbers, or vertices or pixels, that are wrong or not there
  CoverageCounts coverage;          // of Shape::kCoverage
  std::string map;                  // of Shape::kCoverage: the pixels around the first wrong one
};

// `actual` against `expected.values`, by the shape.
Comparison compare(const Expected& expected, const std::vector<double>& actual);

// The answer's field of the same name against what is expected of it. A field that is not there is missing.
Comparison compare(const Expected& expected, const Answer& answer);

// Where a case's answer is wrong: its own judge, or each expected field in turn until one differs.
std::optional<Divergence> judge_case(const Case& input, const Answer& answer);

// The numbers of an answer's field; null if there is none of the name.
const std::vector<double>* find_field(const Answer& answer, const std::string& name);

// Numbers of a vertex, columns of a matrix, pixels of a row; 0 where the shape has no such thing.
int columns_of(const Expected& expected);

// "row 2, column 3", "vertex 4, w", "pixel (10, 12)".
std::string element_name(const Expected& expected, std::size_t index);

// |expected - actual|: 0 for equal infinities and for two NaN, infinity if just one of them is a NaN.
double distance_between(double expected, double actual);

// "missing", "extra", "wrong position", "wrong data", "not a number".
const char* kind_name(Divergence::Kind kind);

}  // namespace glassbox::labs
