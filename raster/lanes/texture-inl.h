// Samples textures for all lanes.

#if defined(GLASSBOX_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_TEXTURE_INL_H_
#undef GLASSBOX_TEXTURE_INL_H_
#else
#define GLASSBOX_TEXTURE_INL_H_
#endif

#include <glassbox/raster/lanes/channels-inl.h>
#include <glassbox/raster/lanes/transfer-inl.h>
#include <glassbox/raster/texture.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

using Float3 = std::array<Floats, 3>;
using Float2 = std::array<Floats, 2>;

// Red, green and blue; opaque surfaces do not need alpha.
using Rgb = std::array<Floats, 3>;

// Converts stored bytes to linear light, red in the lowest byte (base/little_endian.h).
HWY_INLINE Rgb decoded(Transfer transfer, Ints stored) {
  return {decode(transfer, stored & 255), decode(transfer, shifted_right<8>(stored) & 255),
          decode(transfer, shifted_right<16>(stored) & 255)};
}
HWY_INLINE Floats decoded_alpha(Ints stored) {
  return decode_unorm8(shifted_right<24>(stored) & 255);
}

HWY_INLINE Int16x4 mix(const Int16x4& a, const Int16x4& b, Ints f) {
  return mix_whole(a, b, four_copies(f));
}
HWY_INLINE Int16x2 mix(const Int16x2& a, const Int16x2& b, Ints f) {
  return mix_whole(a, b, two_copies(f));
}

// The bytes of texels whose light is stored linearly, equal to encode_unorm8() of color_of(). A
// byte is 128 units of kFullTexel, and rounding the light keeps it on the same side of each half
// (tests/raster/texture_test.cpp checks all values).
HWY_INLINE Ints linear_bytes_of(const Int16x4& texels) {
  return bytes_of(shifted_right<7>(texels + int16x4_of(64)));
}

// The interface to a mip chain that formulas/texture.h expects.
template <class Channels>
class TextureInLanes {
public:
  HWY_INLINE TextureInLanes(const MipChain& chain, const Channels& channels)
      : channels_(channels),
        texels_(reinterpret_cast<const std::int64_t*>(chain.texels.data())),
        first_(chain.first.data()),
        width_(chain.width),
        height_(chain.height),
        last_level_(chain.last_level()) {
    static_assert(sizeof(Texel) == sizeof(std::int64_t));
  }

  int last_level() const { return last_level_; }
  HWY_INLINE TextureLevelOf<std::int32_t> base() const { return {width_, height_, 0}; }
  HWY_INLINE TextureLevelOf<Ints> level(Ints k) const {
    return {side_of_level(width_, k), side_of_level(height_, k), first_of(k)};
  }
  template <class Size>
  HWY_INLINE typename Channels::Texels texel(const TextureLevelOf<Size>& level, Ints x,
                                             Ints y) const {
    return channels_.texels(texels_, y * level.width + x + level.first);
  }

private:
  // A mip chain hardly ever has more levels than the longest vectors have lanes. So the table of
  // all levels fits in one vector.
  HWY_INLINE Ints first_of(Ints level) const {
    if constexpr (kLanes == 16) {
      if (HWY_LIKELY(last_level_ < int(kLanes))) {
        const auto levels = hn::FirstN(kI, std::size_t(last_level_) + 1);
        return hn::TableLookupLanes(hn::MaskedLoad(levels, kI, first_),
                                    hn::IndicesFromVec(kI, level.v));
      }
    }
    return hn::GatherIndex(kI, first_, level.v);
  }

  [[no_unique_address]] Channels channels_;
  const std::int64_t* texels_;
  const std::int32_t* first_;  // by level
  std::int32_t width_, height_, last_level_;
};

// Does the same as sample_texture(), for samplers that use only the base level.
template <class Channels>
HWY_INLINE typename Channels::Texels sample_base(const TextureInLanes<Channels>& texels,
                                                 const Sampler& sampler,
                                                 const std::array<Floats, 2>& texcoord) {
  return sample_level(texels, sampler, sampler.magnify, texels.base(),
                      wrap_coordinate(sampler.wrap_u, texcoord[0]),
                      wrap_coordinate(sampler.wrap_v, texcoord[1]));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
