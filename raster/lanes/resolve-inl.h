// What is seen at a tile's pixels becomes colours, distances and numbers in the framebuffer: once for each pixel, whatever was drawn
// over whatever.

#if defined(GLASSBOX_RESOLVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_RESOLVE_INL_H_
#undef GLASSBOX_RESOLVE_INL_H_
#else
#define GLASSBOX_RESOLVE_INL_H_
#endif

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <type_traits>

#include <hwy/cache_control.h>

#include <glassbox/raster/lanes/shade-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

HWY_INLINE VF distance_lanes(const ResolveJob& job, VF depth, VF inverse_w) {
  if (job.perspective) return hn::Div(set(1.0f), inverse_w);
  return round_to_float(each_half(
      [&](VD d) HWY_ATTR {
        const VD from_near = job.reversed ? hn::Sub(hn::Set(kD, 1.0), d) : d;
        return hn::Add(hn::Set(kD, job.near), hn::Mul(from_near, hn::Set(kD, job.far - job.near)));
      },
      promote(depth)));
}

// A line of the cache.
inline constexpr std::ptrdiff_t kLineBytes = 64, kLineWords = kLineBytes / 4;

// The pixels of a quad, row by row.
struct QuadPixels {
  HWY_ALIGN std::int32_t color[kQuadPixels];
  HWY_ALIGN float distance[kQuadPixels];
  HWY_ALIGN std::int32_t id[kQuadPixels];
};

// Calls work(row, columns) for the quad's rows that lie on the screen. Almost all quads do so wholly, and copying a number of bytes
// that the compiler knows is one instruction.
template <class Work>
HWY_INLINE void for_each_row(const PixelRect& window, int x, int y, const Work& work) {
  if (HWY_LIKELY(x + kQuadSide <= window.x1 && y + kQuadSide <= window.y1)) {
    for (int row = 0; row < kQuadSide; ++row) {
      work(row, std::integral_constant<std::size_t, kQuadSide>());
    }
    return;
  }
  const auto columns = std::size_t(std::min(kQuadSide, window.x1 - x));
  const int rows = std::min(kQuadSide, window.y1 - y);
  for (int row = 0; row < rows; ++row) work(row, columns);
}

template <class To, class From>
HWY_INLINE void store_quad(const From* from, Image<To>& image, const PixelRect& window, int x,
                           int y) {
  static_assert(sizeof(To) == sizeof(From));
  To* to = image.pixels.data() + image.index(x, y);
  for_each_row(window, x, y, [&](int row, auto columns) HWY_ATTR {
    std::memcpy(static_cast<void*>(to + std::size_t(row) * std::size_t(image.width)),
                from + row * kQuadSide, columns * sizeof(To));
  });
}
template <class To, class From>
HWY_INLINE void load_quad(From* to, const Image<To>& image, const PixelRect& window, int x, int y) {
  static_assert(sizeof(To) == sizeof(From));
  const To* from = image.pixels.data() + image.index(x, y);
  for_each_row(window, x, y, [&](int row, auto columns) HWY_ATTR {
    std::memcpy(to + row * kQuadSide,
                static_cast<const void*>(from + std::size_t(row) * std::size_t(image.width)),
                columns * sizeof(To));
  });
}

inline std::int32_t bytes_of(const ColorMask& mask) {
  const Rgba8 bytes{std::uint8_t(mask.r ? 255 : 0), std::uint8_t(mask.g ? 255 : 0),
                    std::uint8_t(mask.b ? 255 : 0), std::uint8_t(mask.a ? 255 : 0)};
  return std::bit_cast<std::int32_t>(bytes);
}

class TileResolver {
public:
  TileResolver(const ResolveJob& job, TileBuffer& tile)
      : job_(job),
        tile_(tile),
        mask_(bytes_of(job.mask)),
        has_other_planes_(job.picture != nullptr || job.distance != nullptr || job.id != nullptr),
        colors_only_(job.picture != nullptr && job.distance == nullptr && job.id == nullptr &&
                     !job.keep_picture && mask_ == -1) {}

  void resolve() {
    const PixelRect& window = tile_.window();
    if (const auto color = color_of_all(); color && has_one_depth()) {
      stream_rows(*job_.picture, *color);
      if (job_.depth != nullptr) stream_rows(*job_.depth, code_of(tile_.block(0)));
      hwy::FlushStream();
      return;
    }
    for (int y = window.y0; y < window.y1; y += kBlockSide) {
      for (int x = window.x0; x < window.x1; x += kBlockSide) {
        const std::size_t block =
            tile_.block_index((x - window.x0) / kBlockSide, (y - window.y0) / kBlockSide);
        if (colors_only_ && tile_.block(block).plain && x + kBlockSide <= window.x1 &&
            y + kBlockSide <= window.y1) {
          resolve_plain_block(block, x, y);
          continue;
        }
        for (int quad = 0; quad < kBlockQuads; ++quad) {
          const int qx = x + (quad % 2) * kQuadSide, qy = y + (quad / 2) * kQuadSide;
          if (qx < window.x1 && qy < window.y1) resolve_quad(block, quad, qx, qy);
        }
      }
    }
  }

private:
  // The colour of every pixel, where nothing is seen in the whole tile, or one thing of one colour.
  std::optional<Rgba8> color_of_all() const {
    const TileBlock& first = tile_.block(0);
    const auto same = [&](const TileBlock& b) { return b.plain && b.reference == first.reference; };
    if (!colors_only_ || !std::all_of(&first, &first + tile_.block_count(), same)) return {};
    if (first.reference == kNothing) return job_.background;
    return job_.large[first.reference & ~kLargeReference]->color;
  }

  bool has_one_depth() const {
    if (job_.depth == nullptr) return true;
    const TileBlock& first = tile_.block(0);
    return std::all_of(&first, &first + tile_.block_count(), [&](const TileBlock& b) {
      return b.triangle == nullptr && b.nearest == first.nearest;
    });
  }

  // Of a plain block whose pixels have the same.
  static std::uint32_t code_of(const TileBlock& b) {
    return b.nearest == kEmptyTileDepth ? kEmptyDepth : std::uint32_t(b.nearest);
  }

  // Past the cache, line by line: nothing of this frame reads it again, and lines that are written whole need not be read.
  template <class Pixel>
  HWY_INLINE void stream_rows(Image<Pixel>& image, Pixel value) const {
    const PixelRect& window = tile_.window();
    const auto word = std::bit_cast<std::uint32_t>(value);
    const VU words = hn::Set(kU, word);
    for (int y = window.y0; y < window.y1; ++y) {
      auto* to = reinterpret_cast<std::uint32_t*>(image.pixels.data() + image.index(window.x0, y));
      std::uint32_t* const end = to + (window.x1 - window.x0);
      for (; to < end && reinterpret_cast<std::uintptr_t>(to) % kLineBytes != 0; ++to) *to = word;
      for (; end - to >= kLineWords; to += kLineWords) {
        for (std::ptrdiff_t i = 0; i < kLineWords; i += std::ptrdiff_t(kLanes))
          hn::Stream(words, kU, to + i);
      }
      for (; to < end; ++to) *to = word;
    }
  }

  // A block in which one thing is seen, or nothing.
  HWY_INLINE void resolve_plain_block(std::size_t block, int x, int y) {
    const TileBlock& b = tile_.block(block);
    if (job_.depth != nullptr) store_plain_depths(block, x, y);
    if (b.reference == kNothing) return fill_rows(*job_.picture, x, y, job_.background);
    const LargeTriangle& triangle = *job_.large[b.reference & ~kLargeReference];
    if (triangle.color) return fill_rows(*job_.picture, x, y, *triangle.color);
    const LargeShape& shape = shape_of(b.reference);
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      const int qx = x + (quad % 2) * kQuadSide, qy = y + (quad / 2) * kQuadSide;
      HWY_ALIGN std::int32_t colors[kQuadPixels];
      for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
        hn::Store(shade(job_.draws[triangle.draw], job_, LargeSource(shape, qx, qy, k)), kI,
                  colors + k);
      }
      store_quad(colors, *job_.picture, tile_.window(), qx, qy);
    }
  }

  template <class Pixel>
  HWY_INLINE static void fill_rows(Image<Pixel>& image, int x, int y, Pixel value) {
    const hn::CappedTag<std::uint32_t, kBlockSide> d;
    const auto words = hn::Set(d, std::bit_cast<std::uint32_t>(value));
    auto* to = reinterpret_cast<std::uint32_t*>(image.pixels.data() + image.index(x, y));
    for (int row = 0; row < kBlockSide; ++row, to += image.width) {
      for (std::size_t i = 0; i < kBlockSide; i += hn::Lanes(d)) hn::StoreU(words, d, to + i);
    }
  }

  HWY_INLINE void store_plain_depths(std::size_t block, int x, int y) {
    const TileBlock& b = tile_.block(block);
    if (b.triangle == nullptr) {
      fill_rows(*job_.depth, x, y, code_of(b));
      return;
    }
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      HWY_ALIGN std::int32_t codes[kQuadPixels];
      fill_quad_depths(*b.triangle, tile_.format(), x + (quad % 2) * kQuadSide,
                       y + (quad / 2) * kQuadSide, codes);
      store_quad(codes, *job_.depth, tile_.window(), x + (quad % 2) * kQuadSide,
                 y + (quad / 2) * kQuadSide);
    }
  }

  HWY_INLINE void resolve_quad(std::size_t block, int quad, int x, int y) {
    if (job_.depth != nullptr) store_depths(block, quad, x, y);
    const TileBlock& b = tile_.block(block);
    if (!has_other_planes_) return;
    if (b.plain && b.reference == kNothing && job_.keep_picture) return;
    QuadPixels pixels;
    if (job_.keep_picture) {
      load(pixels, x, y);
    } else {
      clear(pixels);
    }
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      const auto* at = reinterpret_cast<const std::int32_t*>(
          tile_.reference() + block * kBlockPixels + std::size_t(quad) * kQuadPixels + k);
      resolve_lanes(b.plain ? set(std::int32_t(b.reference)) : hn::Load(kI, at), x, y, k, pixels);
    }
    const PixelRect& window = tile_.window();
    if (job_.picture != nullptr) store_quad(pixels.color, *job_.picture, window, x, y);
    if (job_.distance != nullptr) store_quad(pixels.distance, *job_.distance, window, x, y);
    if (job_.id != nullptr) store_quad(pixels.id, *job_.id, window, x, y);
  }

  // Plain blocks are filled in where their depths differ.
  HWY_INLINE void store_depths(std::size_t block, int quad, int x, int y) {
    if (tile_.block(block).triangle != nullptr) make_plain_block_full(tile_, block);
    const TileBlock& b = tile_.block(block);
    HWY_ALIGN std::int32_t codes[kQuadPixels];
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      const TileDepth* at =
          tile_.depth() + block * kBlockPixels + std::size_t(quad) * kQuadPixels + k;
      const VI depth = b.plain ? set(b.nearest) : hn::Load(kI, at);
      const MI empty = hn::Eq(depth, set(kEmptyTileDepth));
      hn::Store(hn::IfThenElse(empty, set(std::int32_t(kEmptyDepth)), depth), kI, codes + k);
    }
    store_quad(codes, *job_.depth, tile_.window(), x, y);
  }

  HWY_INLINE void clear(QuadPixels& pixels) const {
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      hn::Store(set(std::bit_cast<std::int32_t>(job_.background)), kI, pixels.color + k);
      hn::Store(set(std::numeric_limits<float>::infinity()), kF, pixels.distance + k);
      hn::Store(hn::Zero(kI), kI, pixels.id + k);
    }
  }

  HWY_INLINE void load(QuadPixels& pixels, int x, int y) const {
    const PixelRect& window = tile_.window();
    if (job_.picture != nullptr) load_quad(pixels.color, *job_.picture, window, x, y);
    if (job_.distance != nullptr) load_quad(pixels.distance, *job_.distance, window, x, y);
    if (job_.id != nullptr) load_quad(pixels.id, *job_.id, window, x, y);
  }

  HWY_INLINE void resolve_lanes(VI seen, int x, int y, std::size_t k, QuadPixels& pixels) {
    MI pending = hn::And(hn::Ne(seen, set(std::int32_t(kNothing))),
                         hn::Ne(seen, set(std::int32_t(kInPicture))));
    while (!hn::AllFalse(kI, pending)) {
      HWY_ALIGN std::int32_t references[kLanes];
      hn::Store(seen, kI, references);
      const auto first = Reference(references[hn::FindFirstTrue(kI, pending)]);
      MI same;
      if ((first & kLargeReference) != 0) {
        same = hn::And(pending, hn::Eq(seen, set(std::int32_t(first))));
        const LargeShape& shape = shape_of(first);
        finish(job_.draws[shape.triangle->draw], LargeSource(shape, x, y, k), same, k, pixels);
      } else {
        const ShadeDraw& draw = draw_of(first);
        const VI begin = set(std::int32_t(draw.first_reference));
        same = hn::And(pending, hn::And(at_least(seen, begin),
                                        hn::Lt(seen, set(std::int32_t(draw.end_reference)))));
        const VI reference = hn::IfThenElse(same, seen, set(std::int32_t(first)));
        const SmallSource source(draw, hn::Sub(reference, begin), hn::Add(quad_columns(k), set(x)),
                                 hn::Add(quad_rows(k), set(y)));
        finish(draw, source, same, k, pixels);
      }
      pending = hn::AndNot(same, pending);
    }
  }

  template <class Source>
  HWY_INLINE void finish(const ShadeDraw& draw, const Source& source, MI lanes, std::size_t k,
                         QuadPixels& pixels) {
    if (job_.picture != nullptr) {
      const VI before = hn::Load(kI, pixels.color + k);
      const VI mask = set(mask_);
      const VI color = hn::Or(hn::And(shade(draw, job_, source), mask), hn::AndNot(mask, before));
      hn::Store(hn::IfThenElse(lanes, color, before), kI, pixels.color + k);
    }
    if (job_.distance != nullptr) {
      const VF distance = distance_lanes(job_, source.depth(), source.at().inverse_w);
      hn::Store(hn::IfThenElse(as_float_mask(lanes), distance, hn::Load(kF, pixels.distance + k)),
                kF, pixels.distance + k);
    }
    if (job_.id != nullptr) {
      hn::Store(hn::IfThenElse(lanes, source.id(), hn::Load(kI, pixels.id + k)), kI, pixels.id + k);
    }
  }

  const LargeShape& shape_of(Reference reference) {
    if (reference != shape_reference_) {
      shape_reference_ = reference;
      shape_ = LargeShape(*job_.large[reference & ~kLargeReference]);
    }
    return shape_;
  }

  const ShadeDraw& draw_of(Reference reference) {
    if (draw_ == nullptr || reference < draw_->first_reference ||
        reference >= draw_->end_reference) {
      const auto after = std::upper_bound(
          job_.by_reference.begin(), job_.by_reference.end(), reference,
          [&](Reference r, std::uint32_t draw) { return r < job_.draws[draw].first_reference; });
      draw_ = &job_.draws[*(after - 1)];
    }
    return *draw_;
  }

  const ResolveJob& job_;
  TileBuffer& tile_;
  std::int32_t mask_;
  bool has_other_planes_;
  bool colors_only_;  // all channels of them, and depth perhaps
  // Of the pixels before: neighbours are likely to have the same.
  const ShadeDraw* draw_ = nullptr;
  Reference shape_reference_ = kNothing;
  LargeShape shape_;
};

inline void resolve_tile(const ResolveJob& job, TileBuffer& tile) {
  TileResolver(job, tile).resolve();
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
