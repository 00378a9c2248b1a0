// Which fragments of a draw there are, by their alpha.

#if defined(GLASSBOX_ALPHA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_ALPHA_INL_H_
#undef GLASSBOX_ALPHA_INL_H_
#else
#define GLASSBOX_ALPHA_INL_H_
#endif

#include <glassbox/raster/lanes/shade-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// All that are covered.
struct Opaque {
  static constexpr bool kTests = false;
};

// Those whose alpha reaches the material's cutoff, asked where they are shaded.
class Masked {
public:
  static constexpr bool kTests = true;

  HWY_INLINE explicit Masked(const AlphaTest& test)
      : test_(test), texture_(DrawTextures(*test.draw).color) {}

  // Of the quad at (x, y), the pixels k .. k + kLanes - 1 that the small triangle of this reference covers ...
  HWY_INLINE IntMask kept(IntMask lanes, Reference reference, int x, int y, std::size_t k) const {
    const Ints of_draw = std::int32_t(reference - test_.draw->first_reference);
    return kept(lanes, SmallSource(*test_.draw, of_draw, quad_columns(k) + x, quad_rows(k) + y,
                                   AtSamples{test_.points, lanes}));
  }
  // ... or the large one.
  HWY_INLINE IntMask kept(IntMask lanes, const LargeShape& shape, int x, int y,
                          std::size_t k) const {
    return kept(lanes, LargeSource(shape, x, y, k, AtSamples{test_.points, lanes}));
  }

private:
  template <class Source>
  HWY_INLINE IntMask kept(IntMask lanes, const Source& source) const {
    const Floats alpha = surface_alpha(*test_.draw, texture_, source);
    return lanes && int_mask(alpha >= test_.draw->material->alpha_cutoff);
  }

  const AlphaTest& test_;
  const MipChain* texture_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
