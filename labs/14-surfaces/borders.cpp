#include "labs/14-surfaces/borders.h"

#include <algorithm>
#include <map>

#include "views/polygons/cell_table.h"

namespace glassbox::labs {

// A border consists of the sides of triangles that belong to one triangle only: a side that two
// triangles share appears a second time in the opposite direction, and is left out.
std::vector<std::vector<int>> borders_in_cell(unsigned inside) {
  std::map<int, int> next;
  const auto& triangles = views::consistent_table()[inside].triangles;
  const auto has = [&](int a, int b) {
    return std::any_of(triangles.begin(), triangles.end(), [&](const views::CellTriangle& t) {
      return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
    });
  };
  for (const views::CellTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!has(t[(k + 1) % 3], t[k])) next[t[k]] = t[(k + 1) % 3];
    }
  }
  std::vector<std::vector<int>> borders;
  while (!next.empty()) {
    borders.emplace_back();
    for (int at = next.begin()->first; next.contains(at);) {
      borders.back().push_back(at);
      const int after = next[at];
      next.erase(at);
      at = after;
    }
  }
  return borders;
}

}  // namespace glassbox::labs
