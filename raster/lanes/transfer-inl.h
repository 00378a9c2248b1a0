// Between stored bytes and linear light: transfer.h over lanes.

#if defined(GLASSBOX_TRANSFER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_TRANSFER_INL_H_
#undef GLASSBOX_TRANSFER_INL_H_
#else
#define GLASSBOX_TRANSFER_INL_H_
#endif

#include <glassbox/raster/lanes/lanes-inl.h>
#include <glassbox/raster/lanes/srgb_tables.h>
#include <glassbox/raster/transfer.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// decode_unorm8(): byte / 255 = byte / 256 + byte / 65280. The first term is exact, the second errs by 2^-24 of 1/255 of the
// result, and the sum is rounded: the same float as the division's, for each of the 256 bytes (tests/raster/lanes).
HWY_INLINE VF decode_unorm8(VI byte) {
  const VF b = to_float(byte);
  return hn::Add(hn::Mul(b, set(1.0f / 256)), hn::Mul(b, set(1.0f / 65280)));
}

HWY_INLINE VF decode(Transfer transfer, VI byte) {
  if (transfer == Transfer::kNone) return decode_unorm8(byte);
  return hn::GatherIndex(kF, kLinearOfSrgb.data(), byte);
}

// encode_unorm8(): floor(255 v + 1/2). With c the floor of the rounded product, the code is c or c + 1: c + 1 where 255 v >= c + 1/2,
// that is 256 v - (c + 1/2) >= v. The product with 256 is exact, and near the tie so is the difference (Sterbenz), so the
// comparison is decided as in exact arithmetic.
HWY_INLINE VI encode_unorm8(VF value) {
  const VF v = hn::IfThenElseZero(hn::Gt(value, hn::Zero(kF)),
                                  hn::IfThenElse(hn::Lt(value, set(1.0f)), value, set(1.0f)));
  const VF below = hn::Floor(hn::Mul(v, set(255.0f)));
  const MF up = hn::Ge(hn::Sub(hn::Mul(v, set(256.0f)), hn::Add(below, set(0.5f))), v);
  return hn::Sub(hn::ConvertTo(kI, below), hn::VecFromMask(kI, as_int_mask(up)));
}

// encode_srgb(), by the same tables with entries of 32 bits.
HWY_INLINE VI encode_srgb(VF linear) {
  const VF lowest = set(kSrgbThreshold[1]), highest = set(kSrgbThreshold[255]);
  const MF some = hn::Ge(linear, lowest);
  const MF all = hn::Ge(linear, highest);
  const VF inside = hn::IfThenElse(hn::AndNot(all, some), linear, lowest);
  const VI bucket = hn::Sub(hn::ShiftRight<srgb_detail::kBucketShift>(hn::BitCast(kI, inside)),
                            set(std::int32_t(srgb_detail::kFirstBucket)));
  const VI code = hn::GatherIndex(kI, kCodeOfBucket32.data(), bucket);
  const VF next = hn::GatherIndex(kF, kSrgbThreshold.data() + 1, code);
  const VI found = hn::Sub(code, hn::VecFromMask(kI, as_int_mask(hn::Ge(inside, next))));
  return hn::IfThenElse(as_int_mask(all), set(255), hn::IfThenElseZero(as_int_mask(some), found));
}

HWY_INLINE VI encode(Transfer transfer, VF linear) {
  return transfer == Transfer::kSrgb ? encode_srgb(linear) : encode_unorm8(linear);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
