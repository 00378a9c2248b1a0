// Text tables, and units for their times.
#pragma once

#include <string>
#include <vector>

namespace glassbox {

// Rows with the same number of words, printed in columns as wide as their widest word. The first
// `left` columns are aligned to the left, the others (numbers) to the right. Empty columns are left
// out.
using Row = std::vector<std::string>;
std::string table(const std::vector<Row>& rows, std::size_t left);

// A unit in which times are printed.
struct TimeUnit {
  double ns = 1;
  const char* name = "ns";
};
// The largest unit in which the shortest time has digits before the decimal point.
TimeUnit time_unit(double shortest_ns);

}  // namespace glassbox
