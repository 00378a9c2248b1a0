// Samples from images over lanes that look at one level each; samples between two levels, and those whose filters differ from
// lane to lane, are left to sample() of texture.h.

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

HWY_INLINE Rgb decode_texel(Ints texel, Transfer transfer) {
  static_assert(std::endian::native == std::endian::little);
  return {decode(transfer, texel & 255), decode(transfer, shifted_right<8>(texel) & 255),
          decode(transfer, shifted_right<16>(texel) & 255)};
}

// sample() for samplers that look at the base level alone.
HWY_INLINE Rgb sample_base(const MipChain& texture, const Sampler& sampler,
                           const std::array<Floats, 2>& texcoord, Transfer transfer) {
  const Image<Rgba8>& image = texture.levels.front();
  const auto* pixels = reinterpret_cast<const std::int32_t*>(image.pixels.data());
  const auto texel = [&](Ints x, Ints y) HWY_ATTR {
    return decode_texel(hn::GatherIndex(kI, pixels, (y * image.width + x).v), transfer);
  };
  const Floats u = wrap_coordinate(sampler.wrap_u, texcoord[0]);
  const Floats v = wrap_coordinate(sampler.wrap_v, texcoord[1]);
  return sampler.magnify == Filter::kNearest
             ? sample_nearest(sampler, image.width, image.height, u, v, texel)
             : sample_linear(sampler, image.width, image.height, u, v, texel);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
