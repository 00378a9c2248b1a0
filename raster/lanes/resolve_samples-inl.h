// Resolves the samples of a tile's pixels to the pixels' colours.

#if defined(GLASSBOX_RESOLVE_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_RESOLVE_SAMPLES_INL_H_
#undef GLASSBOX_RESOLVE_SAMPLES_INL_H_
#else
#define GLASSBOX_RESOLVE_SAMPLES_INL_H_
#endif

#include <algorithm>
#include <bit>

#include <glassbox/raster/lanes/shared_samples-inl.h>
#include <glassbox/raster/lanes/tile_rows-inl.h>
#include <glassbox/raster/lanes/visible_shader-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

class SampleResolver {
public:
  SampleResolver(const ResolveJob& job, std::span<TileBuffer> tiles,
                 VisibleShader<AllChannels>& shader)
      : job_(job), tiles_(tiles), shader_(shader), mask_(bytes_of(job.mask)) {}

  // Resolves a block's samples. Each triangle that is seen at some of a pixel's samples is shaded
  // once in that pixel.
  HWY_NOINLINE void resolve(std::size_t block, int x, int y, const Rows& rows) {
    const TrianglesAtSamples listed(tiles_, block);
    if (listed.count > 0) {
      const ShadeDraw& draw = shader_.draw_of(Reference(hn::GetLane(listed.references.v)));
      if (SharedTriangles::can_share(draw)) {
        return resolve(block, x, y, rows, SharedTrianglesAtSamples(draw, listed, x, y));
      }
    }
    resolve(block, x, y, rows, NoSharedTriangles());
  }

private:
  struct ToSample {
    HWY_INLINE AtSamples shading_point(IntMask lanes) const { return {job.points, lanes}; }
    template <class Source>
    HWY_INLINE void shade_and_store(const ShadeDraw& draw, const DrawTextures& textures,
                                    const Source& source, IntMask lanes) const {
      const Ints shaded =
          encoded(shaded_color_by_call<AllChannels>(draw, textures, job, source), job);
      color = select(lanes, shaded, color);
    }
    const ResolveJob& job;
    Ints& color;
  };

  template <class Shared>
  HWY_NOINLINE void resolve(std::size_t block, int x, int y, const Rows& rows,
                            const Shared& shared) {
    SampleColors colors;
    RemainingSamples remaining;
    HWY_ALIGN std::int32_t means[kBlockPixels];
    for_each_quad(x, y, [&](int quad, int qx, int qy) HWY_ATTR {
      std::int32_t* const background = means + quad * kQuadPixels;
      if (job_.keep_picture && job_.samples == nullptr) {
        load_quad(background, rows, tiles_.front().window(), qx, qy);
      } else {
        std::fill_n(background, kQuadPixels, std::bit_cast<std::int32_t>(job_.background));
      }
      for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
        shade_samples(block, quad, qx, qy, k, load(background + k), shared, colors, remaining);
      }
    });
    shade_remaining(remaining, x, y, shared, colors);
    for_each_quad(x, y, [&](int quad, int qx, int qy) HWY_ATTR {
      for (std::size_t k = 0; k < kQuadPixels; k += kLanes)
        copy_equal_samples(block, quad, k, colors);
      if (job_.samples != nullptr) return store_samples(block, quad, qx, qy, colors);
      const std::size_t first = std::size_t(quad) * kQuadPixels;
      for (std::size_t k = first; k < first + kQuadPixels; k += kLanes) {
        const Ints mean = mean_color(job_.transfer, colors, tiles_.size(), k);
        store(merged_channels(mean, load(means + k), mask_), means + k);
      }
      store_quad(means + first, rows, tiles_.front().window(), qx, qy);
    });
  }
  // Calls `work` for the quads that have pixels on the screen.
  template <class Work>
  HWY_INLINE void for_each_quad(int x, int y, const Work& work) const {
    const PixelRect& window = tiles_.front().window();
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      const int qx = x + (quad % 2) * kQuadSide, qy = y + (quad / 2) * kQuadSide;
      if (qx < window.x1 && qy < window.y1) work(quad, qx, qy);
    }
  }

  // Shades pixels k .. k + kLanes - 1 of a quad: the first sample of each pixel, and the other
  // samples that show large triangles. The other samples that show small triangles are only
  // collected in `remaining`, because few lanes have one; they are shaded later, in full vectors.
  // `background` is the colour of samples that show nothing.
  template <class Shared>
  HWY_INLINE void shade_samples(std::size_t block, int quad, int x, int y, std::size_t k,
                                Ints background, const Shared& shared, SampleColors& colors,
                                RemainingSamples& remaining) {
    const std::size_t pixel = std::size_t(quad) * kQuadPixels + k;
    Ints seen[kMaxSamples];
    for (std::size_t s = 0; s < tiles_.size(); ++s) {
      seen[s] = visible_references(tiles_[s], block, quad, k);
      Ints color = background;
      IntMask pending = is_to_be_shaded(seen[s]);
      for (std::size_t t = 0; t < s; ++t) pending = pending && seen[s] != seen[t];
      if (s > 0) {
        const IntMask small = pending && seen[s] >= 0;  // the sign bit is kLargeReference
        if (!none(small)) remaining.add(seen[s], small, s, pixel);
        pending = pending && !small;
      } else {
        shared.shade(job_, seen[s], block_columns(pixel / kLanes), block_rows(pixel / kLanes),
                     pending, color);
      }
      shader_.shade_lanes(seen[s], pending, x, y, k, ToSample{job_, color});
      store(color, colors.at(s) + pixel);
    }
  }
  // Shades the samples that were collected in `remaining`. The lanes of a vector may be any pixels
  // of the block at (x, y), so the small triangle is looked up for each lane.
  template <class Shared>
  HWY_NOINLINE void shade_remaining(const RemainingSamples& remaining, int x, int y,
                                    const Shared& shared, SampleColors& colors) {
    for (std::size_t i = 0; i < remaining.count; i += kLanes) {
      const Ints seen = load(remaining.references + i), index = load(remaining.color_indices + i);
      const Ints column = (index & 3) | (shifted_right<2>(index) & 4);
      const Ints row = (shifted_right<2>(index) & 3) | (shifted_right<3>(index) & 4);
      IntMask pending = first_lanes(std::min(kLanes, remaining.count - i));
      Ints color = 0;
      shared.shade(job_, seen, column, row, pending, color);
      while (!none(pending)) {
        HWY_ALIGN std::int32_t references[kLanes];
        store(seen, references);
        const auto first = Reference(references[hn::FindFirstTrue(kI, pending.m)]);
        const ShadeDraw& draw = shader_.draw_of(first);
        const Ints begin = std::int32_t(draw.first_reference);
        const IntMask same = pending && seen >= begin && seen < std::int32_t(draw.end_reference);
        const Ints reference = select(same, seen, std::int32_t(first));
        const SmallSource source(draw, reference - begin, column + x, row + y,
                                 AtSamples{job_.points, same});
        color = select(same,
                       encoded(shaded_color_by_call<AllChannels>(draw, shader_.textures_of(draw),
                                                                 job_, source),
                               job_),
                       color);
        pending = pending && !same;
      }
      HWY_ALIGN std::int32_t shaded[kLanes];
      store(color, shaded);
      const std::size_t count = std::min(kLanes, remaining.count - i);
      for (std::size_t lane = 0; lane < count; ++lane) {
        colors.colors[remaining.color_indices[i + lane]] = shaded[lane];
      }
    }
  }
  // A triangle seen at several of a pixel's samples was shaded at the first of them; its colour is
  // copied to the other samples.
  HWY_INLINE void copy_equal_samples(std::size_t block, int quad, std::size_t k,
                                     SampleColors& colors) const {
    const std::size_t pixel = std::size_t(quad) * kQuadPixels + k;
    Ints seen[kMaxSamples];
    for (std::size_t s = 0; s < tiles_.size(); ++s) {
      seen[s] = visible_references(tiles_[s], block, quad, k);
      Ints color = load(colors.at(s) + pixel);
      for (std::size_t t = 0; t < s; ++t) {
        color = select(seen[s] == seen[t], load(colors.at(t) + pixel), color);
      }
      store(color, colors.at(s) + pixel);
    }
  }

  // Stores the samples' colours and all depths in job.samples, for later draws. (This is rare, so
  // it is done pixel by pixel.)
  void store_samples(std::size_t block, int quad, int x, int y, const SampleColors& colors) {
    for (std::size_t s = 0; s < tiles_.size(); ++s) {
      TileBuffer& tile = tiles_[s];
      make_plain_block_full(tile, block);
      const std::size_t first = block * kBlockPixels + std::size_t(quad) * kQuadPixels;
      for_each_row(tiles_.front().window(), x, y, [&](int row, auto columns) {
        for (int column = 0; column < int(columns); ++column) {
          const int i = row * kQuadSide + column;
          const Reference seen = tile.reference()[first + std::size_t(i)];
          const std::size_t to = job_.samples->at(x + column, y + row) + s;
          job_.samples->depths[to] = stored_code(tile.depth()[first + std::size_t(i)]);
          if (seen == kNothing || seen == kInPicture) continue;
          auto& color = job_.samples->colors[to];
          const std::int32_t seen_color = colors.at(s)[quad * kQuadPixels + i];
          color = std::bit_cast<Rgba8>((seen_color & mask_) |
                                       (std::bit_cast<std::int32_t>(color) & ~mask_));
        }
      });
    }
  }

  const ResolveJob& job_;
  std::span<TileBuffer> tiles_;  // one for each sample
  VisibleShader<AllChannels>& shader_;
  std::int32_t mask_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
