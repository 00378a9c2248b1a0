// Tables of text, and the units of their times.
#pragma once

#include <string>
#include <vector>

namespace glassbox::app {

// Rows of as many words, printed in columns as wide as their widest word: the first `left` stand to the left, the others,
// numbers, to the right. Columns without a word are left out.
using Row = std::vector<std::string>;
std::string table(const std::vector<Row>& rows, std::size_t left);

// In which times are told.
struct TimeUnit {
  double ns = 1;
  const char* name = "ns";
};
// The one in which the shortest of them has digits before the point.
TimeUnit time_unit(double shortest_ns);

}  // namespace glassbox::app
