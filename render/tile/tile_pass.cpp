#include <glassbox/render/tile/tile_pass.h>

#include <algorithm>

#include <glassbox/render/staged/lines_points.h>
#include <glassbox/render/staged/watch.h>
#include <glassbox/render/tile/tile_buffers.h>

namespace glassbox {

namespace {

// Draws primitives by the stages of the reference into the framebuffer; their colours go to the
// samples, if there are any.
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
                            .samples = samples,
                            .behind_depth = pass.behind_depth};
  const CountingWatch watch(statistics);
  for (const std::uint32_t entry : bin) {
    std::size_t i = entry & ~kChunkEntryBit;
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

// A tile being drawn, either by the vectorised code into the tile's own buffers or by the stages of
// the reference into the framebuffer. When drawing changes from one of these two to the other, the
// tile's contents are copied.
class TileDrawing {
public:
  // `overwrite`: at the end all pixels of the tile are written, also those where nothing is seen.
  TileDrawing(const TilePass& pass, const PixelRect& window, bool overwrite, TileMemory& memory,
              std::uint32_t* both_eyes, Statistics& statistics)
      : pass_(pass),
        window_(window),
        buffers_(begin_buffers(pass, window, memory)),
        own_planes_(memory.planes),
        centre_planes_(pass.resolve),
        sample_colors_(pass.resolve),
        statistics_(statistics) {
    if (overwrite) centre_planes_.keep_picture = sample_colors_.keep_picture = false;
    if (is_sampled()) centre_planes_.picture = nullptr;
    centre_planes_.tile_colors = both_eyes;
    sample_colors_.distance = nullptr;
    sample_colors_.id = nullptr;
    sample_colors_.points = sample_offsets(pass.run.settings.samples);
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
    statistics_.written += counts_.written + counts_.blended;
    statistics_.blended += counts_.blended;
    statistics_.discarded += counts_.discarded;
    statistics_.depth_failed +=
        counts_.covered - counts_.discarded - counts_.written - counts_.blended;
  }

private:
  void draw_over_lanes(const Chunk& chunk, std::span<const std::uint32_t> bin) {
    if (in_framebuffer_) {
      load();
      in_framebuffer_ = false;
    }
    begin_lanes(chunk);
    const DrawSlot& slot = pass_.round.slots[chunk.slot];
    const SmallJob job{slot.indices->positions.data(), slot.screen, slot.first_reference};
    const auto is_large = [](std::uint32_t entry) { return (entry & kChunkEntryBit) != 0; };
    for (auto at = bin.begin(); at != bin.end();) {
      const auto large = std::find_if(at, bin.end(), is_large);
      if (large != at) {
        const std::span small(&*at, std::size_t(large - at));
        draw_small(slot, job, small);
      }
      at = large;
      for (; at != bin.end() && is_large(*at); ++at) {
        const std::uint32_t index = chunk.first_large + (*at & ~kChunkEntryBit);
        buffers_.for_each([&](TileBuffer& tile) { draw_large(slot, index, tile); });
      }
    }
  }

  // Before a blended draw, the colours of what is seen so far are written to the picture, because
  // the draw is blended with them. Depths stay in the buffers.
  void begin_lanes(const Chunk& chunk) {
    if (alpha_mode(pass_.round.slots[chunk.slot]) != AlphaMode::kBlend) {
      colors_left_ = false;
    } else if (!colors_left_) {
      if (!buffers_.samples.empty()) use_planes();
      leave_buffers(false);
      buffers_.for_each(mark_as_in_picture);
      colors_left_ = true;
    }
  }

  void draw_small(const DrawSlot& slot, const SmallJob& job, TriangleNumbers triangles) {
    const Kernels& k = pass_.kernels;
    if (pass_.behind_depth != nullptr) {
      TileBuffer& tile = *buffers_.centres;
      return k.behind.small(job, behind_test(slot, tile), triangles, tile, counts_);
    }
    switch (alpha_mode(slot)) {
      case AlphaMode::kOpaque:
        if (buffers_.centres != nullptr) {
          k.draw_small(job, triangles, {buffers_.centres, 1}, counts_);
        }
        if (!buffers_.samples.empty()) k.draw_small(job, triangles, buffers_.samples, counts_);
        return;
      case AlphaMode::kMask:
        return buffers_.for_each([&](TileBuffer& tile) {
          k.masked.small(job, alpha_test(slot, tile), triangles, tile, counts_);
        });
      case AlphaMode::kBlend:
        return buffers_.for_each([&](TileBuffer& tile) {
          k.blended.small(job, blend_job(slot, tile), triangles, tile, counts_);
        });
    }
  }

  void draw_large(const DrawSlot& slot, std::uint32_t index, TileBuffer& tile) {
    const Kernels& k = pass_.kernels;
    const LargeTriangle& triangle = *pass_.round.large[index];
    const Reference reference = kLargeReference | index;
    if (pass_.behind_depth != nullptr)
      return k.behind.large(triangle, behind_test(slot, tile), reference, tile, counts_);
    switch (alpha_mode(slot)) {
      case AlphaMode::kOpaque:
        return k.draw_large(triangle.setup, reference, tile, counts_);
      case AlphaMode::kMask:
        return k.masked.large(triangle, alpha_test(slot, tile), reference, tile, counts_);
      case AlphaMode::kBlend:
        return k.blended.large(triangle, blend_job(slot, tile), reference, tile, counts_);
    }
  }

  AlphaMode alpha_mode(const DrawSlot& slot) const {
    return pass_.run.list.draws[slot.draw].material->alpha_mode;
  }
  bool is_sampled() const { return samples_drawn(pass_.run.settings) > 1; }

  const ShadeDraw& shade_of(const DrawSlot& slot) const {
    return pass_.resolve.draws[std::size_t(&slot - pass_.round.slots.data())];
  }

  // Returns the samples of a pixel; where a fragment is shaded depends on which of them it covers.
  // Empty for the buffer of pixel centres, where the fragment is shaded at the centre.
  std::span<const SampleOffset> points_of(const TileBuffer& tile) const {
    if (&tile == buffers_.centres) return {};
    return sample_offsets(pass_.run.settings.samples);
  }
  AlphaTest alpha_test(const DrawSlot& slot, const TileBuffer& tile) const {
    return {&shade_of(slot), points_of(tile)};
  }

  BehindTest behind_test(const DrawSlot& slot, const TileBuffer& tile) const {
    return {pass_.behind_depth,
            alpha_mode(slot) == AlphaMode::kMask ? alpha_test(slot, tile) : AlphaTest()};
  }

  BlendJob blend_job(const DrawSlot& slot, const TileBuffer& tile) const {
    const bool centres = &tile == buffers_.centres;
    BlendJob job{
        &shade_of(slot), centres ? &centre_planes_ : &sample_colors_, points_of(tile), nullptr, {}};
    if (!centres) {
      job.rows = planes_->rows();
      job.colors = job.rows.colors + (&tile - buffers_.samples.data());
    } else if (centre_planes_.picture != nullptr) {
      Image<Rgba8>& picture = *centre_planes_.picture;
      job.colors = picture.pixels.data();
      job.rows = {{0, 0, picture.width, picture.height}, job.colors, nullptr, 1};
    }
    return job;
  }

  void draw_staged(const Chunk& chunk, std::span<const std::uint32_t> bin) {
    if (is_sampled()) use_planes();
    if (!in_framebuffer_) {
      leave_buffers(true);
      in_framebuffer_ = true;
    }
    colors_left_ = true;
    draw_staged_primitives(pass_, chunk, bin, window_, planes_, statistics_);
  }

  // Gives the tile's samples memory for their colours and depths (planes_), if they have none yet.
  void use_planes() {
    if (planes_ != nullptr) return;
    planes_ = &own_planes_;
    planes_->clear(window_, pass_.run.settings.samples, pass_.color);
  }

  // Copies the tile from its buffers to the framebuffer.
  void leave_buffers(bool with_depth) {
    if (buffers_.centres != nullptr) {
      ResolveJob resolve = centre_planes_;
      resolve.depth = with_depth ? &pass_.target.depth : nullptr;
      pass_.kernels.resolve_tile(resolve, {buffers_.centres, 1});
    }
    if (buffers_.samples.empty()) return;
    ResolveJob resolve = sample_colors_;
    SampleRows rows;
    if (planes_ != nullptr) {
      rows = planes_->rows();
      resolve.samples = &rows;
    }
    pass_.kernels.resolve_tile(resolve, buffers_.samples);
  }

  // Copies the tile from the framebuffer to its buffers.
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
  // The samples' colours and depths, which staged and blended draws need. planes_ refers to those
  // of the whole picture, if it is drawn in several rounds (parts of its draws); to own_planes_,
  // once such a draw comes; otherwise it is null.
  SamplePlanes& own_planes_;
  SamplePlanes* planes_ = nullptr;
  // The pass's job of writing the tile, for the values of pixel centres and for the colours of
  // samples.
  ResolveJob centre_planes_, sample_colors_;
  Statistics& statistics_;
  FragmentCounts counts_;
  bool in_framebuffer_ = false;
  bool colors_left_ = false;  // the colours of all that is seen so far are already written
};

// Whether a chunk (some primitives of a draw) needs the framebuffer: the stages of the reference
// write there, and blended draws need the colours that are there.
bool draws_into_framebuffer(const TilePass& pass, std::span<const std::uint32_t> chunks) {
  return std::ranges::any_of(chunks, [&](std::uint32_t i) {
    const Chunk& chunk = pass.round.chunks[i];
    const Draw& draw = pass.run.list.draws[pass.round.slots[chunk.slot].draw];
    return chunk.kind != Chunk::Kind::kLanes || draw.material->alpha_mode == AlphaMode::kBlend;
  });
}

bool has_any_behind_depth(const Image<std::uint32_t>& behind_depth, const PixelRect& window) {
  for (int y = window.y0; y < window.y1; ++y) {
    const std::uint32_t* const row = &behind_depth.at(0, y);
    if (std::any_of(row + window.x0, row + window.x1,
                    [](std::uint32_t code) { return code != kEmptyDepth; }))
      return true;
  }
  return false;
}

}  // namespace

void draw_tile(const TilePass& pass, int x, int y, TileMemory& memory, std::uint32_t* both_eyes,
               Statistics& statistics) {
  const int side = pass.run.tile_side;
  const PixelRect window{x * side, y * side, std::min((x + 1) * side, pass.run.window.x1),
                         std::min((y + 1) * side, pass.run.window.y1)};
  const std::span chunks(pass.round.chunks_of_tile[pass.run.tile_index(x, y)]);
  const bool overwrite = pass.overwrite_untouched && !draws_into_framebuffer(pass, chunks);
  TileDrawing drawing(pass, window, overwrite, memory, both_eyes, statistics);
  if (pass.behind_depth == nullptr || has_any_behind_depth(*pass.behind_depth, window)) {
    for (const std::uint32_t i : chunks)
      drawing.draw(pass.round.chunks[i], pass.round.chunks[i].bin(x, y));
  }
  drawing.finish();
}

}  // namespace glassbox
