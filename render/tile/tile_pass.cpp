#include <glassbox/render/tile/tile_pass.h>

#include <algorithm>

#include <glassbox/raster/samples.h>
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

// What the lanes draw a tile into: its pixel centres, its samples, or both.
struct TileBuffers {
  TileBuffer* centres = nullptr;  // null: nobody looks at them
  std::span<TileBuffer> samples;

  template <class Visit>
  void for_each(const Visit& visit) const {
    if (centres != nullptr) visit(*centres);
    for (TileBuffer& tile : samples) visit(tile);
  }
};

// With one sample to a pixel, it is at the centre. With several they have the colours, and centres what other planes there are.
TileBuffers begin_buffers(const TilePass& pass, const PixelRect& window, TileMemory& memory) {
  const RenderSettings& settings = pass.run.settings;
  const int count = samples_drawn(settings);
  TileBuffers buffers;
  const Framebuffer& target = pass.target;
  const bool planes =
      !target.depth.pixels.empty() || !target.distance.pixels.empty() || !target.id.pixels.empty();
  if (count == 1 || planes) {
    buffers.centres = &memory.centres;
    buffers.centres->clear(window, settings.depth);
  }
  if (count == 1 || pass.resolve.picture == nullptr) return buffers;
  const std::span<const SampleOffset> points = sample_offsets(count);
  while (memory.samples.size() < points.size()) memory.samples.emplace_back(pass.run.tile_side);
  buffers.samples = std::span(memory.samples).first(points.size());
  for (std::size_t s = 0; s < points.size(); ++s) {
    buffers.samples[s].clear(window, settings.depth, points[s]);
  }
  return buffers;
}

// Every pixel gets the depth that depth_of(x, y) has for it, and shows what is in the picture already. (Beyond the screen's edge
// nothing is shown, but whole quads are read.)
template <class DepthOf>
void load_tile(TileBuffer& tile, const DepthOf& depth_of) {
  std::fill_n(tile.reference(), tile.block_count() * kBlockPixels, kInPicture);
  for (std::size_t i = 0; i < tile.block_count(); ++i) {
    tile.block(i) = {0, kEmptyTileDepth, false, kNothing, nullptr};
  }
  const PixelRect& window = tile.window();
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      tile.depth()[tile.pixel_index(x, y)] = tile_depth(depth_of(x, y));
    }
  }
}

// A tile being drawn: by the lanes, in its own buffers, or by the staged fragments, in the framebuffer. Primitives of one kind
// after those of the other make it change over.
class TileDrawing {
public:
  TileDrawing(const TilePass& pass, const PixelRect& window, TileMemory& memory,
              Statistics& statistics)
      : pass_(pass),
        window_(window),
        buffers_(begin_buffers(pass, window, memory)),
        own_planes_(memory.planes),
        statistics_(statistics) {
    if (!pass.target.samples.empty()) planes_ = &pass.target.samples;
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
    if (!in_framebuffer_) leave_buffers(pass_.store_depth);
    if (planes_ == &own_planes_) planes_->resolve(pass_.run.settings, pass_.color);
    statistics_.covered += counts_.covered;
    statistics_.written += counts_.written;
    statistics_.discarded += counts_.discarded;
    statistics_.depth_failed += counts_.covered - counts_.discarded - counts_.written;
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
        const std::span small(&*at, std::size_t(large - at));
        buffers_.for_each([&](TileBuffer& tile) { draw_small(slot, job, small, tile); });
      }
      at = large;
      for (; at != bin.end() && is_large(*at); ++at) {
        const std::uint32_t index = chunk.first_large + (*at & ~kOfChunk);
        buffers_.for_each([&](TileBuffer& tile) { draw_large(slot, index, tile); });
      }
    }
  }

  void draw_small(const DrawSlot& slot, const SmallJob& job,
                  std::span<const std::uint32_t> triangles, TileBuffer& tile) {
    if (is_masked(slot)) {
      pass_.kernels.draw_small_masked(job, alpha_test(slot, tile), triangles.data(),
                                      triangles.size(), tile, counts_);
    } else {
      pass_.kernels.draw_small(job, triangles.data(), triangles.size(), tile, counts_);
    }
  }

  void draw_large(const DrawSlot& slot, std::uint32_t index, TileBuffer& tile) {
    const LargeTriangle& triangle = *pass_.round.large[index];
    const Reference reference = kLargeReference | index;
    if (is_masked(slot)) {
      pass_.kernels.draw_large_masked(triangle, alpha_test(slot, tile), reference, tile, counts_);
    } else {
      pass_.kernels.draw_large(triangle.setup, reference, tile, counts_);
    }
  }

  bool is_masked(const DrawSlot& slot) const {
    return pass_.run.list.draws[slot.draw].material->alpha_mode == AlphaMode::kMask;
  }
  // Where a fragment is shaded is one place, whichever of its samples asks; for its centre, that.
  AlphaTest alpha_test(const DrawSlot& slot, const TileBuffer& tile) const {
    AlphaTest test{&pass_.resolve.draws[slot.draw], {}};
    if (&tile != buffers_.centres) test.points = sample_offsets(pass_.run.settings.samples);
    return test;
  }

  void draw_staged(const Chunk& chunk, std::span<const std::uint32_t> bin) {
    if (samples_drawn(pass_.run.settings) > 1 && planes_ == nullptr) {
      planes_ = &own_planes_;
      planes_->clear(window_, pass_.run.settings.samples, pass_.color);
    }
    if (!in_framebuffer_) {
      leave_buffers(true);
      in_framebuffer_ = true;
    }
    draw_staged_primitives(pass_, chunk, bin, window_, planes_, statistics_);
  }

  // From the buffers to the framebuffer.
  void leave_buffers(bool with_depth) {
    ResolveJob resolve = pass_.resolve;
    const bool sampled = samples_drawn(pass_.run.settings) > 1;
    if (buffers_.centres != nullptr) {
      resolve.depth = with_depth ? &pass_.target.depth : nullptr;
      if (sampled) resolve.picture = nullptr;
      pass_.kernels.resolve_tile(resolve, {buffers_.centres, 1});
    }
    if (buffers_.samples.empty()) return;
    resolve = pass_.resolve;
    resolve.depth = nullptr;
    resolve.distance = nullptr;
    resolve.id = nullptr;
    resolve.points = sample_offsets(pass_.run.settings.samples);
    SampleRows rows;
    if (planes_ != nullptr) {
      rows = planes_->rows();
      resolve.samples = &rows;
    }
    pass_.kernels.resolve_tile(resolve, buffers_.samples);
  }

  // From the framebuffer to the buffers.
  void load() {
    if (buffers_.centres != nullptr) {
      load_tile(*buffers_.centres, [&](int x, int y) { return pass_.target.depth.at(x, y); });
    }
    for (std::size_t s = 0; s < buffers_.samples.size(); ++s) {
      load_tile(buffers_.samples[s], [&](int x, int y) { return planes_->depths(x, y)[s]; });
    }
  }

  const TilePass& pass_;
  PixelRect window_;
  TileBuffers buffers_;
  // Where samples are while staged draws need them: those of the whole picture, where it is drawn in several rounds; the tile's
  // own, once such a draw comes; otherwise nowhere.
  SamplePlanes& own_planes_;
  SamplePlanes* planes_ = nullptr;
  Statistics& statistics_;
  FragmentCounts counts_;
  bool in_framebuffer_ = false;
};

}  // namespace

void draw_tile(const TilePass& pass, int x, int y, TileMemory& memory, Statistics& statistics) {
  const int side = pass.run.tile_side;
  const PixelRect window{x * side, y * side, std::min((x + 1) * side, pass.run.window.x1),
                         std::min((y + 1) * side, pass.run.window.y1)};
  TileDrawing drawing(pass, window, memory, statistics);
  for (std::size_t i = 0; i < pass.round.chunk_count; ++i) {
    drawing.draw(pass.round.chunks[i], pass.round.chunks[i].bin(x, y));
  }
  drawing.finish();
}

}  // namespace glassbox
