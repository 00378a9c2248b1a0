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

// The pixels of a quad, row by row.
struct QuadPixels {
  HWY_ALIGN std::int32_t color[kQuadPixels];
  HWY_ALIGN float distance[kQuadPixels];
  HWY_ALIGN std::int32_t id[kQuadPixels];
};

template <class To, class From>
HWY_INLINE void store_quad(const From* from, Image<To>& image, const PixelRect& window, int x,
                           int y) {
  static_assert(sizeof(To) == sizeof(From));
  const int columns = std::min(kQuadSide, window.x1 - x), rows = std::min(kQuadSide, window.y1 - y);
  for (int row = 0; row < rows; ++row) {
    std::memcpy(static_cast<void*>(&image.pixels[image.index(x, y + row)]), from + row * kQuadSide,
                std::size_t(columns) * sizeof(To));
  }
}
template <class To, class From>
HWY_INLINE void load_quad(From* to, const Image<To>& image, const PixelRect& window, int x, int y) {
  static_assert(sizeof(To) == sizeof(From));
  const int columns = std::min(kQuadSide, window.x1 - x), rows = std::min(kQuadSide, window.y1 - y);
  for (int row = 0; row < rows; ++row) {
    std::memcpy(to + row * kQuadSide, &image.pixels[image.index(x, y + row)],
                std::size_t(columns) * sizeof(To));
  }
}

inline std::int32_t bytes_of(const ColorMask& mask) {
  const Rgba8 bytes{std::uint8_t(mask.r ? 255 : 0), std::uint8_t(mask.g ? 255 : 0),
                    std::uint8_t(mask.b ? 255 : 0), std::uint8_t(mask.a ? 255 : 0)};
  return std::bit_cast<std::int32_t>(bytes);
}

class TileResolver {
public:
  TileResolver(const ResolveJob& job, const TileBuffer& tile)
      : job_(job), tile_(tile), mask_(bytes_of(job.mask)) {}

  void resolve() {
    const PixelRect& window = tile_.window();
    for (int y = window.y0; y < window.y1; y += kBlockSide) {
      for (int x = window.x0; x < window.x1; x += kBlockSide) {
        const std::size_t block =
            tile_.block_index((x - window.x0) / kBlockSide, (y - window.y0) / kBlockSide);
        for (int quad = 0; quad < kBlockQuads; ++quad) {
          const int qx = x + (quad % 2) * kQuadSide, qy = y + (quad / 2) * kQuadSide;
          if (qx < window.x1 && qy < window.y1) resolve_quad(block, quad, qx, qy);
        }
      }
    }
  }

private:
  HWY_INLINE void resolve_quad(std::size_t block, int quad, int x, int y) {
    const TileBlock& b = tile_.block(block);
    if (b.plain && b.reference == kNothing && job_.keep_picture) return;
    QuadPixels pixels;
    if (job_.keep_picture) load(pixels, x, y);
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

  HWY_INLINE void load(QuadPixels& pixels, int x, int y) const {
    const PixelRect& window = tile_.window();
    if (job_.picture != nullptr) load_quad(pixels.color, *job_.picture, window, x, y);
    if (job_.distance != nullptr) load_quad(pixels.distance, *job_.distance, window, x, y);
    if (job_.id != nullptr) load_quad(pixels.id, *job_.id, window, x, y);
  }

  HWY_INLINE void resolve_lanes(VI seen, int x, int y, std::size_t k, QuadPixels& pixels) {
    if (!job_.keep_picture) {
      hn::Store(set(std::bit_cast<std::int32_t>(job_.background)), kI, pixels.color + k);
      hn::Store(set(std::numeric_limits<float>::infinity()), kF, pixels.distance + k);
      hn::Store(hn::Zero(kI), kI, pixels.id + k);
    }
    MI pending = hn::And(hn::Ne(seen, set(std::int32_t(kNothing))),
                         hn::Ne(seen, set(std::int32_t(kInPicture))));
    while (!hn::AllFalse(kI, pending)) {
      HWY_ALIGN std::int32_t references[kLanes];
      hn::Store(seen, kI, references);
      const auto first = Reference(references[hn::FindFirstTrue(kI, pending)]);
      MI same;
      if ((first & kLargeReference) != 0) {
        same = hn::And(pending, hn::Eq(seen, set(std::int32_t(first))));
        const LargeTriangle& triangle = *job_.large[first & ~kLargeReference];
        finish(job_.draws[triangle.draw], LargeSource(triangle, x, y, k), same, k, pixels);
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
  const TileBuffer& tile_;
  std::int32_t mask_;
  const ShadeDraw* draw_ = nullptr;  // of the pixel before
};

inline void resolve_tile(const ResolveJob& job, const TileBuffer& tile) {
  TileResolver(job, tile).resolve();
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
