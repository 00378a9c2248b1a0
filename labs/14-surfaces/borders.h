// The polygons that a cell's surface is made of, by the table of views/polygons.
#pragma once

#include <vector>

namespace glassbox::labs {

// The border of each piece of the surface in a cell whose corners `inside` (bit by bit) are inside: numbers of edges, each from its
// lowest, the pieces by their lowest edges.
std::vector<std::vector<int>> borders_in_cell(unsigned inside);

}  // namespace glassbox::labs
