#include "cli/report/table.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

namespace glassbox {

std::string table(const std::vector<Row>& rows, std::size_t left) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (widths[i] == 0) continue;
      line += i < left ? fmt::format("{:<{}}  ", row[i], widths[i])
                       : fmt::format("{:>{}}  ", row[i], widths[i]);
    }
    text += "  " + line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

TimeUnit time_unit(double shortest_ns) {
  return shortest_ns < 1e3   ? TimeUnit{1, "ns"}
         : shortest_ns < 1e6 ? TimeUnit{1e3, "us"}
                             : TimeUnit{1e6, "ms"};
}

}  // namespace glassbox
