#include <glassbox/render/tile/tile_pass.h>

#include <algorithm>

#include <glassbox/render/staged/lines_points.h>
#include <glassbox/render/staged/watch.h>

namespace glassbox {

namespace {

TileDepth tile_depth(std::uint32_t code) {
  return code == kEmptyDepth ? kEmptyTileDepth : TileDepth(code);
}

// By the staged fragments, into the framebuffer; colours into the samples, if there are any.
void draw_staged_primitives(const TilePass& pass, const Chunk& chunk,
                            std::span<const std::uint32_t> bin, const PixelRect& window,
                            SamplePlanes* samples, Statistics& statistics) {
  const Draw& draw = pass.run.list.draws[pass.round.slots[chunk.slot].draw];
  const FragmentStage stage{.draw = draw,
                            .channels = shaded_channels(draw, pass.run.settings),
                            .view = pass.run.view,
                            .settings = pass.run.settings,
                            .lighting = pass.run.list.lighting,
                            .target = pass.target,
                            .color = pass.color,
                            .window = window,
                            .samples = samples};
  const Counting watch(statistics);
  for (const std::uint32_t entry : bin) {
    std::size_t i = entry & ~kOfChunk;
    if (i < chunk.triangles.size()) {
      rasterise(stage, watch, chunk.triangles[i]);
      continue;
    }
    i -= chunk.triangles.size();
    if (i < chunk.lines.size()) {
      rasterise(stage, watch, chunk.lines[i]);
    } else {
      rasterise(stage, watch, chunk.points[i - chunk.lines.size()]);
    }
  }
}

// A tile being drawn: by the lanes, in its own buffer, or by the staged fragments, in the framebuffer. Primitives of one kind
// after those of the other make it change over.
class TileDrawing {
public:
  TileDrawing(const TilePass& pass, const PixelRect& window, TileBuffer& tile,
              Statistics& statistics)
      : pass_(pass), tile_(tile), statistics_(statistics) {
    tile_.clear(window, pass.run.settings.depth);
    if (pass.load_depth) load();
  }

  void draw(const Chunk& chunk, std::span<const std::uint32_t> bin) {
    if (bin.empty()) return;
    if (chunk.kind == Chunk::Kind::kLanes) {
      draw_over_lanes(chunk, bin);
    } else {
      draw_staged(chunk, bin);
    }
  }

  void finish() {
    if (!in_framebuffer_) leave_buffer(pass_.store_depth);
    statistics_.covered += counts_.covered;
    statistics_.written += counts_.written;
    statistics_.depth_failed += counts_.covered - counts_.written;
  }

private:
  void draw_over_lanes(const Chunk& chunk, std::span<const std::uint32_t> bin) {
    if (in_framebuffer_) {
      load();
      in_framebuffer_ = false;
    }
    const DrawSlot& slot = pass_.round.slots[chunk.slot];
    const Draw& draw = pass_.run.list.draws[slot.draw];
    const SmallJob job{draw.prepared->indices.positions.data(), slot.screen, slot.first_reference};
    const auto is_large = [](std::uint32_t entry) { return (entry & kOfChunk) != 0; };
    for (auto at = bin.begin(); at != bin.end();) {
      const auto large = std::find_if(at, bin.end(), is_large);
      if (large != at) {
        pass_.kernels.draw_small(job, &*at, std::size_t(large - at), tile_, counts_);
      }
      at = large;
      for (; at != bin.end() && is_large(*at); ++at) {
        const std::uint32_t index = chunk.first_large + (*at & ~kOfChunk);
        pass_.kernels.draw_large(pass_.round.large[index]->setup, kLargeReference | index, tile_,
                                 counts_);
      }
    }
  }

  void draw_staged(const Chunk& chunk, std::span<const std::uint32_t> bin) {
    if (!in_framebuffer_) {
      leave_buffer(true);
      in_framebuffer_ = true;
    }
    draw_staged_primitives(pass_, chunk, bin, tile_.window(), nullptr, statistics_);
  }

  // From the buffer to the framebuffer.
  void leave_buffer(bool with_depth) {
    ResolveJob resolve = pass_.resolve;
    resolve.depth = with_depth ? &pass_.target.depth : nullptr;
    pass_.kernels.resolve_tile(resolve, tile_);
  }

  // From the framebuffer to the buffer: depths, and for every pixel that what it shows is in the picture already. (Beyond the
  // screen's edge nothing is shown, but whole quads are read.)
  void load() {
    std::fill_n(tile_.reference(), tile_.block_count() * kBlockPixels, kInPicture);
    for (std::size_t i = 0; i < tile_.block_count(); ++i) {
      tile_.block(i) = {0, kEmptyTileDepth, false, kNothing, nullptr};
    }
    for_each_pixel([&](int x, int y, std::size_t i) {
      tile_.depth()[i] = tile_depth(pass_.target.depth.at(x, y));
    });
  }

  template <class Visit>
  void for_each_pixel(const Visit& visit) const {
    const PixelRect& window = tile_.window();
    for (int y = window.y0; y < window.y1; ++y) {
      for (int x = window.x0; x < window.x1; ++x) visit(x, y, tile_.pixel_index(x, y));
    }
  }

  const TilePass& pass_;
  TileBuffer& tile_;
  Statistics& statistics_;
  FragmentCounts counts_;
  bool in_framebuffer_ = false;
};

}  // namespace

namespace {

// All draws are staged then. One round's samples are the tile's own; those of several are the picture's.
void draw_samples(const TilePass& pass, int x, int y, const PixelRect& window,
                  SamplePlanes& of_tile, Statistics& statistics) {
  const bool one_round = pass.target.samples.empty();
  SamplePlanes& samples = one_round ? of_tile : pass.target.samples;
  if (one_round) samples.clear(window, pass.run.settings.samples, pass.color);
  for (std::size_t i = 0; i < pass.round.chunk_count; ++i) {
    const Chunk& chunk = pass.round.chunks[i];
    draw_staged_primitives(pass, chunk, chunk.bin(x, y), window, &samples, statistics);
  }
  if (one_round) samples.resolve(pass.run.settings, pass.color);
}

}  // namespace

void draw_tile(const TilePass& pass, int x, int y, TileMemory& memory, Statistics& statistics) {
  const int side = pass.run.tile_side;
  const PixelRect window{x * side, y * side, std::min((x + 1) * side, pass.run.window.x1),
                         std::min((y + 1) * side, pass.run.window.y1)};
  if (samples_drawn(pass.run.settings) > 1) {
    return draw_samples(pass, x, y, window, memory.samples, statistics);
  }
  TileDrawing drawing(pass, window, memory.buffer, statistics);
  for (std::size_t i = 0; i < pass.round.chunk_count; ++i) {
    drawing.draw(pass.round.chunks[i], pass.round.chunks[i].bin(x, y));
  }
  drawing.finish();
}

}  // namespace glassbox
