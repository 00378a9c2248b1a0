// Samples from images: texture.h over lanes. Lanes look at one level each; samples between two levels, and those whose filters differ
// from lane to lane, are left to the scalar stage.

#if defined(GLASSBOX_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_TEXTURE_INL_H_
#undef GLASSBOX_TEXTURE_INL_H_
#else
#define GLASSBOX_TEXTURE_INL_H_
#endif

#include <bit>
#include <limits>

#include <glassbox/raster/lanes/transfer-inl.h>
#include <glassbox/raster/texture.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

struct RgbLanes {
  VF r, g, b;
};

HWY_INLINE VF mix(VF a, VF b, VF t) {
  return hn::Add(a, hn::Mul(t, hn::Sub(b, a)));
}

HWY_INLINE VF wrap_coordinate(Wrap wrap, VF t) {
  const MF finite = hn::Le(hn::Abs(t), set(std::numeric_limits<float>::max()));
  VF wrapped = t;
  switch (wrap) {
    case Wrap::kRepeat: {
      const VF fraction = hn::Sub(t, hn::Floor(t));
      const VF largest = set(0x1.fffffep-1f);
      wrapped = hn::IfThenElse(hn::Lt(largest, fraction), largest, fraction);
      break;
    }
    case Wrap::kMirroredRepeat:
      wrapped = hn::Sub(t, hn::Mul(set(2.0f), hn::Floor(hn::Mul(t, set(0.5f)))));
      break;
    case Wrap::kClampToEdge:
      wrapped = hn::IfThenElse(hn::Lt(t, hn::Zero(kF)), hn::Zero(kF),
                               hn::IfThenElse(hn::Lt(set(1.0f), t), set(1.0f), t));
      break;
  }
  return hn::IfThenElseZero(finite, wrapped);
}

// `i` is off either end by less than a period.
HWY_INLINE VI wrap_texel(Wrap wrap, VI i, int size) {
  const VI zero = hn::Zero(kI);
  const auto into_period = [&](VI j, int period) HWY_ATTR {
    const VI p = set(period);
    const VI from_below = hn::IfThenElse(hn::Lt(j, zero), hn::Add(j, p), j);
    return hn::IfThenElse(at_least(from_below, p), hn::Sub(from_below, p), from_below);
  };
  switch (wrap) {
    case Wrap::kRepeat:
      return into_period(i, size);
    case Wrap::kMirroredRepeat: {
      const VI j = into_period(i, 2 * size);
      return hn::IfThenElse(hn::Lt(j, set(size)), j, hn::Sub(set(2 * size - 1), j));
    }
    case Wrap::kClampToEdge:
      return hn::Max(zero, hn::Min(i, set(size - 1)));
  }
  return i;
}

// Without alpha, which opaque surfaces have no use for.
HWY_INLINE RgbLanes decode_texel(VI texel, Transfer transfer) {
  static_assert(std::endian::native == std::endian::little);
  const VI byte = set(255);
  return {decode(transfer, hn::And(texel, byte)),
          decode(transfer, hn::And(hn::ShiftRight<8>(texel), byte)),
          decode(transfer, hn::And(hn::ShiftRight<16>(texel), byte))};
}

HWY_INLINE RgbLanes mix(const RgbLanes& a, const RgbLanes& b, VF t) {
  return {mix(a.r, b.r, t), mix(a.g, b.g, t), mix(a.b, b.b, t)};
}

HWY_INLINE VI texel_at(const Image<Rgba8>& image, VI x, VI y) {
  const auto* pixels = reinterpret_cast<const std::int32_t*>(image.pixels.data());
  return hn::GatherIndex(kI, pixels, hn::Add(hn::Mul(y, set(image.width)), x));
}

HWY_INLINE RgbLanes sample_nearest(const Image<Rgba8>& image, const Sampler& sampler, VF u, VF v,
                                   Transfer transfer) {
  const VI x = hn::ConvertTo(kI, hn::Floor(hn::Mul(u, set(float(image.width)))));
  const VI y = hn::ConvertTo(kI, hn::Floor(hn::Mul(v, set(float(image.height)))));
  return decode_texel(texel_at(image, wrap_texel(sampler.wrap_u, x, image.width),
                               wrap_texel(sampler.wrap_v, y, image.height)),
                      transfer);
}

HWY_INLINE RgbLanes sample_linear(const Image<Rgba8>& image, const Sampler& sampler, VF u, VF v,
                                  Transfer transfer) {
  const VF x = hn::Sub(hn::Mul(u, set(float(image.width))), set(0.5f));
  const VF y = hn::Sub(hn::Mul(v, set(float(image.height))), set(0.5f));
  const VF left = hn::Floor(x), above = hn::Floor(y);
  const VF across = hn::Sub(x, left), down = hn::Sub(y, above);
  const VI column = hn::ConvertTo(kI, left), row = hn::ConvertTo(kI, above);
  const VI x0 = wrap_texel(sampler.wrap_u, column, image.width);
  const VI x1 = wrap_texel(sampler.wrap_u, hn::Add(column, set(1)), image.width);
  const VI y0 = wrap_texel(sampler.wrap_v, row, image.height);
  const VI y1 = wrap_texel(sampler.wrap_v, hn::Add(row, set(1)), image.height);
  const auto texel = [&](VI tx, VI ty)
                         HWY_ATTR { return decode_texel(texel_at(image, tx, ty), transfer); };
  return mix(mix(texel(x0, y0), texel(x1, y0), across), mix(texel(x0, y1), texel(x1, y1), across),
             down);
}

// sample() for samplers that look at the base level alone.
HWY_INLINE RgbLanes sample_base(const MipChain& texture, const Sampler& sampler, VF u, VF v,
                                Transfer transfer) {
  const VF wrapped_u = wrap_coordinate(sampler.wrap_u, u);
  const VF wrapped_v = wrap_coordinate(sampler.wrap_v, v);
  const Image<Rgba8>& image = texture.levels.front();
  return sampler.magnify == Filter::kNearest
             ? sample_nearest(image, sampler, wrapped_u, wrapped_v, transfer)
             : sample_linear(image, sampler, wrapped_u, wrapped_v, transfer);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
