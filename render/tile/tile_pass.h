// One tile: what the round's chunks have for it, in order, into the framebuffer.
#pragma once

#include <vector>

#include <glassbox/raster/lanes/kernels.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/staged/ready.h>
#include <glassbox/render/tile/round.h>

namespace glassbox {

// What all tiles of a round share.
struct TilePass {
  const TileRun& run;
  const Kernels& kernels;
  const Round& round;
  // With keep_picture: planes are cleared already, and may hold earlier rounds.
  ResolveJob resolve;
  Framebuffer& target;
  Image<Rgba8>& color;  // target.color, or the picture that this one is drawn over
  // All the same, a tile may overwrite what its planes hold if nothing is drawn into them there.
  bool overwrite_untouched = false;
  // Depth lives in target.depth between rounds, and while staged primitives are drawn.
  bool load_depth = false, store_depth = false;
  const Image<std::uint32_t>* behind = nullptr;  // as EyePicture has it
};

// What a thread keeps of the tile that it draws, and uses again for the next one.
struct TileMemory {
  explicit TileMemory(int side) : centres(side) {}
  TileBuffer centres;
  std::vector<TileBuffer> samples;   // where a pixel has several: a buffer for each
  SamplePlanes planes;               // and where staged draws come among the others
  LineVector<std::uint32_t> colors;  // of a pair's first eye, which the second one draws over
};

// Draws tile (x, y). `statistics` counts fragments. `both_eyes`: where the tile's colours are until the second eye of a pair has drawn, or
// null.
void draw_tile(const TilePass& pass, int x, int y, TileMemory& memory, std::uint32_t* both_eyes,
               Statistics& statistics);

}  // namespace glassbox
