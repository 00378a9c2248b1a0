// Samples from textures over lanes.

#if defined(GLASSBOX_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_TEXTURE_INL_H_
#undef GLASSBOX_TEXTURE_INL_H_
#else
#define GLASSBOX_TEXTURE_INL_H_
#endif

#include <bit>

#include <glassbox/raster/lanes/transfer-inl.h>
#include <glassbox/raster/texture.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Red, green and blue; opaque surfaces have no use for alpha.
using Rgb = std::array<Floats, 3>;

HWY_INLINE Rgb mix(const Rgb& a, const Rgb& b, Floats t) {
  return {mix(a[0], b[0], t), mix(a[1], b[1], t), mix(a[2], b[2], t)};
}

// What of a stored texel is wanted, in linear light.
static_assert(std::endian::native == std::endian::little);
struct ColorOfTexel {
  HWY_INLINE Rgb operator()(Ints texel) const {
    return {decode(transfer, texel & 255), decode(transfer, shifted_right<8>(texel) & 255),
            decode(transfer, shifted_right<16>(texel) & 255)};
  }
  Transfer transfer;
};
struct AlphaOfTexel {
  HWY_INLINE Floats operator()(Ints texel) const {
    return decode_unorm8(shifted_right<24>(texel) & 255);
  }
};

HWY_INLINE Rgb select(FloatMask condition, const Rgb& yes, const Rgb& no) {
  return {select(condition, yes[0], no[0]), select(condition, yes[1], no[1]),
          select(condition, yes[2], no[2])};
}

// The texels of a chain.
template <class OfTexel>
class TextureInLanes {
public:
  HWY_INLINE TextureInLanes(const MipChain& chain, OfTexel of_texel)
      : texels_(reinterpret_cast<const std::int32_t*>(chain.texels.data())),
        first_(chain.first.data()),
        width_(chain.width),
        height_(chain.height),
        last_level_(chain.last_level()),
        of_texel_(of_texel) {}

  int last_level() const { return last_level_; }
  HWY_INLINE TextureLevelOf<std::int32_t> base() const { return {width_, height_, 0}; }
  HWY_INLINE TextureLevelOf<Ints> level(Ints k) const {
    return {side_of_level(width_, k), side_of_level(height_, k), hn::GatherIndex(kI, first_, k.v)};
  }
  template <class Size>
  HWY_INLINE auto texel(const TextureLevelOf<Size>& level, Ints x, Ints y) const {
    return of_texel_(hn::GatherIndex(kI, texels_, (y * level.width + x + level.first).v));
  }

private:
  const std::int32_t* texels_;
  const std::int32_t* first_;  // by level
  std::int32_t width_, height_, last_level_;
  OfTexel of_texel_;
};

// sample() for samplers that look at the base level alone.
template <class OfTexel>
HWY_INLINE auto sample_base(const TextureInLanes<OfTexel>& texels, const Sampler& sampler,
                            const std::array<Floats, 2>& texcoord) {
  return sample_level(texels, sampler, sampler.magnify, texels.base(),
                      wrap_coordinate(sampler.wrap_u, texcoord[0]),
                      wrap_coordinate(sampler.wrap_v, texcoord[1]));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
