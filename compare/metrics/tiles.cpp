#include <glassbox/compare/metrics/tiles.h>

#include <tbb/parallel_for.h>

#include <algorithm>

namespace glassbox {

void for_each_tile(int width, int height, TileSize size,
                   const std::function<void(const PixelBox&)>& work) {
  const int columns = (width + size.width - 1) / size.width;
  const int rows = (height + size.height - 1) / size.height;
  tbb::parallel_for(0, columns * rows, [&](int tile) {
    const int x = tile % columns * size.width;
    const int y = tile / columns * size.height;
    work({x, y, std::min(size.width, width - x), std::min(size.height, height - y)});
  });
}

}  // namespace glassbox
