// Colours of a tile's pixels from those of their samples.

#if defined(GLASSBOX_RESOLVE_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_RESOLVE_SAMPLES_INL_H_
#undef GLASSBOX_RESOLVE_SAMPLES_INL_H_
#else
#define GLASSBOX_RESOLVE_SAMPLES_INL_H_
#endif

#include <algorithm>
#include <bit>

#include <glassbox/raster/lanes/rows-inl.h>
#include <glassbox/raster/lanes/seen-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

class SampleResolver {
public:
  SampleResolver(const ResolveJob& job, std::span<TileBuffer> tiles,
                 SeenShader<AllChannels>& shader)
      : job_(job), tiles_(tiles), shader_(shader), mask_(bytes_of(job.mask)) {}

  // A quad's samples: each triangle that is seen at some of a pixel's is shaded once there.
  HWY_NOINLINE void resolve(std::size_t block, int quad, int x, int y, const Rows& rows) {
    HWY_ALIGN std::int32_t means[kQuadPixels];
    if (job_.keep_picture && job_.samples == nullptr) {
      load_quad(means, rows, tiles_.front().window(), x, y);
    } else {
      std::fill_n(means, kQuadPixels, std::bit_cast<std::int32_t>(job_.background));
    }
    SampleColors colors;
    FurtherSamples further;
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      shade_samples(block, quad, x, y, k, load(means + k), colors, further);
    }
    shader_.shade_further(further, x, y, colors);
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes)
      copy_equal_samples(block, quad, k, colors);
    if (job_.samples != nullptr) return leave_samples(block, quad, x, y, colors);
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      const Ints mean = mean_color(job_.transfer, colors, tiles_.size(), k);
      store((mean & mask_) | (load(means + k) & ~mask_), means + k);
    }
    store_quad(means, rows, tiles_.front().window(), x, y);
  }

private:
  struct ToSample {
    HWY_INLINE AtSamples place(IntMask lanes) const { return {job.points, lanes}; }
    template <class Source>
    HWY_INLINE void take(const ShadeDraw& draw, const DrawTextures& textures, const Source& source,
                         IntMask lanes) const {
      const Ints shaded = encoded(shining_by_call<AllChannels>(draw, textures, job, source), job);
      color = select(lanes, shaded, color);
    }
    const ResolveJob& job;
    Ints& color;
  };

  // Of a quad's pixels k .. k + kLanes - 1: the first samples, and others of large triangles. Small ones wait in `further`, since few lanes
  // have any. `background`: of samples that show nothing.
  HWY_INLINE void shade_samples(std::size_t block, int quad, int x, int y, std::size_t k,
                                Ints background, SampleColors& colors, FurtherSamples& further) {
    Ints seen[kMostSamples];
    for (std::size_t s = 0; s < tiles_.size(); ++s) {
      seen[s] = seen_in(tiles_[s], block, quad, k);
      Ints color = background;
      IntMask pending = is_to_be_shaded(seen[s]);
      for (std::size_t t = 0; t < s; ++t) pending = pending && seen[s] != seen[t];
      if (s > 0) {
        const IntMask small = pending && seen[s] >= 0;  // kLargeReference is the sign
        if (!none(small)) further.add(seen[s], small, s, k);
        pending = pending && !small;
      }
      shader_.shade_lanes(seen[s], pending, x, y, k, ToSample{job_, color});
      store(color, colors.at(s) + k);
    }
  }
  // What is seen at several of a pixel's samples was shaded at the first of them.
  HWY_INLINE void copy_equal_samples(std::size_t block, int quad, std::size_t k,
                                     SampleColors& colors) const {
    Ints seen[kMostSamples];
    for (std::size_t s = 0; s < tiles_.size(); ++s) {
      seen[s] = seen_in(tiles_[s], block, quad, k);
      Ints color = load(colors.at(s) + k);
      for (std::size_t t = 0; t < s; ++t) {
        color = select(seen[s] == seen[t], load(colors.at(t) + k), color);
      }
      store(color, colors.at(s) + k);
    }
  }

  // For other draws to come: what was seen, and all depths. (Not often, and so pixel by pixel.)
  void leave_samples(std::size_t block, int quad, int x, int y, const SampleColors& colors) {
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
          color = std::bit_cast<Rgba8>((colors.at(s)[i] & mask_) |
                                       (std::bit_cast<std::int32_t>(color) & ~mask_));
        }
      });
    }
  }

  const ResolveJob& job_;
  std::span<TileBuffer> tiles_;  // one for each sample
  SeenShader<AllChannels>& shader_;
  std::int32_t mask_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
