// Divides a picture into tiles that fit into a core's cache, and distributes them over the cores.
#pragma once

#include <functional>

#include <glassbox/compare/pixels/selection.h>

namespace glassbox {

struct TileSize {
  int width = 0;   // px
  int height = 0;  // px
};

// Calls `work` once for every tile of a picture of this size, on as many threads as oneTBB has, in
// no particular order. Tiles at the right and lower edge may be smaller.
void for_each_tile(int width, int height, TileSize size,
                   const std::function<void(const PixelBox&)>& work);

}  // namespace glassbox
