// Draws one tile: the primitives that the round's chunks have for it, in order, into the
// framebuffer.
#pragma once

#include <vector>

#include <glassbox/raster/lanes/kernels.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/staged/primitives.h>
#include <glassbox/render/tile/draw_round.h>

namespace glassbox {

// The data that all tiles of a round share.
struct TilePass {
  const TileRun& run;
  const Kernels& kernels;
  const DrawRound& round;
  // With keep_picture: planes are cleared already, and may hold earlier rounds.
  ResolveJob resolve;
  Framebuffer& target;
  Image<Rgba8>& color;  // target.color, or the picture that this one is drawn over
  // Even so, a tile in which nothing is drawn into the planes may overwrite what they hold.
  bool overwrite_untouched = false;
  // Depths are stored in target.depth between rounds, and while staged primitives are drawn.
  bool load_depth = false, store_depth = false;
  const Image<std::uint32_t>* behind_depth = nullptr;  // see EyePicture::behind_depth
};

// The memory of a thread for the tile that it draws; it is used again for the next tile.
struct TileMemory {
  explicit TileMemory(int side) : centres(side) {}
  TileBuffer centres;
  std::vector<TileBuffer> samples;           // a buffer for each sample, if a pixel has several
  SamplePlanes planes;                       // used if there are also staged draws
  CacheAlignedVector<std::uint32_t> colors;  // of a pair's first eye
};

// Draws tile (x, y). `statistics` counts fragments. `both_eyes`: memory for the tile's colours
// until the second eye of a pair has drawn, or null.
void draw_tile(const TilePass& pass, int x, int y, TileMemory& memory, std::uint32_t* both_eyes,
               Statistics& statistics);

}  // namespace glassbox
