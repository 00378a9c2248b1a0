// The polygons of the surface in a cell, from the table of views/polygons.
#pragma once

#include <vector>

namespace glassbox::labs {

// The border of each piece of the surface in a cell whose corners `inside` (one bit each) are
// inside: the numbers of its edges, each border from its lowest edge, the pieces in the order of
// their lowest edges.
std::vector<std::vector<int>> borders_in_cell(unsigned inside);

}  // namespace glassbox::labs
