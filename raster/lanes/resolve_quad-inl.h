// Resolves the pixels of a quad, with one sample per pixel: their colours, distances and triangle
// numbers.

#if defined(GLASSBOX_RESOLVE_QUAD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_RESOLVE_QUAD_INL_H_
#undef GLASSBOX_RESOLVE_QUAD_INL_H_
#else
#define GLASSBOX_RESOLVE_QUAD_INL_H_
#endif

#include <bit>
#include <limits>

#include <glassbox/raster/lanes/tile_rows-inl.h>
#include <glassbox/raster/lanes/visible_shader-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// The pixels of a quad, row by row.
struct QuadPixels {
  HWY_ALIGN std::int32_t color[kQuadPixels];
  HWY_ALIGN float distance[kQuadPixels];
  HWY_ALIGN std::int32_t id[kQuadPixels];
};

template <class Channels>
class QuadResolver {
public:
  QuadResolver(const ResolveJob& job, TileBuffer& tile, const TileRows& rows,
               VisibleShader<Channels>& shader)
      : job_(job), tile_(tile), rows_(rows), shader_(shader), mask_(bytes_of(job.mask)) {}

  // (This is not inlined, like the function for plain blocks: in one function compilers run out of
  // registers.)
  HWY_NOINLINE void resolve(std::size_t block, int quad, int x, int y) {
    if (job_.depth != nullptr) rows_.store_depths(block, quad, x, y);
    if (job_.picture == nullptr && job_.distance == nullptr && job_.id == nullptr) return;
    const TileBlock& b = tile_.block(block);
    const bool is_in_picture = b.reference == kNothing || b.reference == kInPicture;
    if (b.plain && is_in_picture && job_.keep_picture) return;
    QuadPixels pixels;
    if (job_.keep_picture) {
      load_from_picture(pixels, x, y);
    } else {
      clear(pixels);
    }
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      const Ints seen = visible_references(tile_, block, quad, k);
      shader_.shade_lanes(seen, is_to_be_shaded(seen), x, y, k, ToPixels{*this, pixels, k});
    }
    const PixelRect& window = tile_.window();
    if (job_.picture != nullptr) store_quad(pixels.color, rows_.color(), window, x, y);
    if (job_.distance != nullptr)
      store_quad(pixels.distance, rows_of(*job_.distance), window, x, y);
    if (job_.id != nullptr) store_quad(pixels.id, rows_of(*job_.id), window, x, y);
  }

private:
  HWY_INLINE void clear(QuadPixels& pixels) const {
    for (std::size_t k = 0; k < kQuadPixels; k += kLanes) {
      store(std::bit_cast<std::int32_t>(job_.background), pixels.color + k);
      store(std::numeric_limits<float>::infinity(), pixels.distance + k);
      store(0, pixels.id + k);
    }
  }

  HWY_INLINE void load_from_picture(QuadPixels& pixels, int x, int y) const {
    const PixelRect& window = tile_.window();
    if (job_.picture != nullptr) load_quad(pixels.color, rows_.color(), window, x, y);
    if (job_.distance != nullptr) load_quad(pixels.distance, rows_of(*job_.distance), window, x, y);
    if (job_.id != nullptr) load_quad(pixels.id, rows_of(*job_.id), window, x, y);
  }

  // Says at which point of its pixel a fragment is shaded, and where the result is stored.
  struct ToPixels {
    HWY_INLINE AtCentre shading_point(IntMask) const { return {}; }
    template <class Source>
    HWY_INLINE void shade_and_store(const ShadeDraw& draw, const DrawTextures& textures,
                                    const Source& source, IntMask lanes) const {
      resolver.shade_and_store(draw, textures, source, lanes, k, pixels);
    }
    QuadResolver& resolver;
    QuadPixels& pixels;
    std::size_t k;
  };
  template <class Source>
  HWY_INLINE void shade_and_store(const ShadeDraw& draw, const DrawTextures& textures,
                                  const Source& source, IntMask lanes, std::size_t k,
                                  QuadPixels& pixels) {
    if (job_.picture != nullptr) {
      const Ints before = load(pixels.color + k);
      const Ints color =
          merged_channels(shade<Channels>(draw, textures, job_, source), before, mask_);
      store(select(lanes, color, before), pixels.color + k);
    }
    if (job_.distance != nullptr) {
      const Floats distance = distance_of(job_, source.depth(), source.at().inverse_w);
      store(select(float_mask(lanes), distance, load(pixels.distance + k)), pixels.distance + k);
    }
    if (job_.id != nullptr) {
      store(select(lanes, source.id(), load(pixels.id + k)), pixels.id + k);
    }
  }

  const ResolveJob& job_;
  TileBuffer& tile_;
  const TileRows& rows_;
  VisibleShader<Channels>& shader_;
  std::int32_t mask_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
