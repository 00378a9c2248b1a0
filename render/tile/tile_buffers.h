// The buffers into which a tile is drawn: its pixel centres, its samples, or both.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/raster/lanes/tile_buffer.h>
#include <glassbox/render/engine/sample_planes.h>
#include <glassbox/render/tile/tile_pass.h>

namespace glassbox {

// With one sample per pixel, the sample is the centre. With several, `samples` has the colours, and
// `centres` has depth, distance and triangle numbers.
struct TileBuffers {
  TileBuffer* centres = nullptr;  // null: they are not needed
  std::span<TileBuffer> samples;

  template <class Visit>
  void for_each(const Visit& visit) const {
    if (centres != nullptr) visit(*centres);
    for (TileBuffer& tile : samples) visit(tile);
  }
};

// Returns cleared buffers for the tile `window`, from the thread's memory.
TileBuffers begin_buffers(const TilePass& pass, const PixelRect& window, TileMemory& memory);

// Marks everything that the buffer shows as already written to the picture. Its depths are kept.
void mark_as_in_picture(TileBuffer& tile);

// Does the same as mark_as_in_picture(), and sets the depth of every pixel to the code code_of(x,
// y). (Pixels outside the screen are not shown, but they are marked, too, because whole quads are
// read.)
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
