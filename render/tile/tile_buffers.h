// What the lanes draw a tile into: its pixel centres, its samples, or both.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/raster/lanes/tile_buffer.h>
#include <glassbox/render/engine/sample_planes.h>
#include <glassbox/render/tile/tile_pass.h>

namespace glassbox {

// With one sample to a pixel, it is at the centre. With several they have the colours, and centres what other planes there are.
struct TileBuffers {
  TileBuffer* centres = nullptr;  // null: nobody looks at them
  std::span<TileBuffer> samples;

  template <class Visit>
  void for_each(const Visit& visit) const {
    if (centres != nullptr) visit(*centres);
    for (TileBuffer& tile : samples) visit(tile);
  }
};

// Of the thread's memory, cleared.
TileBuffers begin_buffers(const TilePass& pass, const PixelRect& window, TileMemory& memory);

// What the buffer shows is in the picture from now on. Its depths stay.
void mark_as_in_picture(TileBuffer& tile);

// The same, and every pixel gets the depth code that code_of(x, y) has for it. (Beyond the screen's edge nothing is shown, but whole
// quads are read.)
template <class CodeOf>
void load_tile(TileBuffer& tile, const CodeOf& code_of) {
  for (std::size_t i = 0; i < tile.block_count(); ++i) {
    tile.block(i) = {0, kEmptyTileDepth, false, kNothing, nullptr, 0};
  }
  mark_as_in_picture(tile);
  const PixelRect& window = tile.window();
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const std::uint32_t code = code_of(x, y);
      tile.depth()[tile.pixel_index(x, y)] =
          code == kEmptyDepth ? kEmptyTileDepth : TileDepth(code);
    }
  }
}

}  // namespace glassbox
