// Draws one tile into the framebuffer: the primitives that were sorted into it in this round (a
// part of the picture's draws, see DrawRound), in the order of drawing.
#pragma once

#include <vector>

#include <glassbox/raster/lanes/kernels.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/staged/primitives.h>
#include <glassbox/render/tile/draw_round.h>

namespace glassbox {

// The data that all tiles share while a round (a part of the draws) is drawn.
struct TilePass {
  const TileRun& run;
  const Kernels& kernels;
  const DrawRound& round;
  // If resolve.keep_picture is set, the images have been cleared already and may contain earlier
  // rounds.
  ResolveJob resolve;
  Framebuffer& target;
  Image<Rgba8>& color;  // target.color, or a picture over which this one is drawn
  // Even if resolve.keep_picture is set, a tile may overwrite all its pixels if none of its draws
  // needs the framebuffer.
  bool overwrite_untouched = false;
  // Whether a tile's depths are read from target.depth before drawing (in rounds after the first),
  // and whether they are stored there afterwards (if there are several rounds, or if depth is
  // wanted). While staged primitives are drawn, depths are there in any case.
  bool load_depth = false, store_depth = false;
  const Image<std::uint32_t>* behind_depth = nullptr;  // see EyePicture::behind_depth
};

// The memory of a thread for the tile that it draws; it is used again for the next tile.
struct TileMemory {
  explicit TileMemory(int side) : centres(side) {}
  TileBuffer centres;
  std::vector<TileBuffer> samples;           // a buffer for each sample, if a pixel has several
  SamplePlanes planes;                       // used if the tile has staged or blended draws
  CacheAlignedVector<std::uint32_t> colors;  // a tile's colours of a pair's first eye
};

// Draws tile (x, y). `statistics` counts fragments. `both_eyes`: memory for the tile's colours
// until the second eye of a pair has drawn, or null.
void draw_tile(const TilePass& pass, int x, int y, TileMemory& memory, std::uint32_t* both_eyes,
               Statistics& statistics);

}  // namespace glassbox
