// The polygons of the surface in a cell, from the table of views/polygons.
#pragma once

#include <vector>

namespace glassbox::labs {

// The borders of the surface in a cell, as lists of the numbers of the cell's edges that they
// cross. Bit c of `inside` says that corner c of the cell is inside. Each border begins with its
// edge of lowest number, and the borders are in the order of these edges.
std::vector<std::vector<int>> borders_in_cell(unsigned inside);

}  // namespace glassbox::labs
