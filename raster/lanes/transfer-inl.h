// Conversion between stored bytes and linear light. transfer.h is implemented a second time: there
// are 256 codes, so what matters is how they are found, and vector code finds them in another way.
// tests/raster/lanes compares the two implementations: for every byte, at every threshold, and for
// floats of the whole range.

#if defined(GLASSBOX_TRANSFER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_TRANSFER_INL_H_
#undef GLASSBOX_TRANSFER_INL_H_
#else
#define GLASSBOX_TRANSFER_INL_H_
#endif

#include <glassbox/raster/lanes/formulas-inl.h>
#include <glassbox/raster/lanes/srgb_tables.h>
#include <glassbox/raster/transfer.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// decode_unorm8(): byte / 255 = byte / 256 + byte / 65280. The first term is exact, the second has
// an error of at most 2^-24 of 1/255 of the result, and the sum is rounded. The result is the same
// float as that of the division, for each of the 256 bytes.
HWY_INLINE Floats decode_unorm8(Ints byte) {
  const Floats b = to_float(byte);
  return b * (1.0f / 256) + b * (1.0f / 65280);
}

HWY_INLINE Floats decode(Transfer transfer, Ints byte) {
  if (transfer == Transfer::kNone) return decode_unorm8(byte);
  return hn::GatherIndex(kF, kLinearOfSrgb.data(), byte.v);
}

// encode_unorm8(): floor(255 v + 1/2) for v in [0, 1]. If c is the floor of the rounded product 255
// v, the code is c or c + 1. It is c + 1 if 255 v >= c + 1/2, that is 256 v - (c + 1/2) >= v. The
// product with 256 is exact, and if 256 v is near c + 1/2 so is the difference (Sterbenz's
// theorem), so the comparison is decided as in exact arithmetic.
HWY_INLINE Ints encode_unorm8(Floats value) {
  const Floats v = in_unit_range(value);
  const Ints below = to_integer(v * 255.0f);
  return below + one_where(v * 256.0f - (to_float(below) + 0.5f) >= v);
}

// encode_srgb() with a single table look-up. Below the first bucket the code is 0, the same as at
// the bucket's lowest float.
HWY_INLINE Ints encode_srgb(Floats linear) {
  const Floats lowest = float_of(Ints(std::int32_t(srgb_detail::kFirstBucket << 16)));
  const Floats highest = kSrgbThreshold[255];
  const Ints bits = bits_of(greatest(lowest, least(linear, highest)));
  const Ints bucket =
      shifted_right<srgb_detail::kBucketShift>(bits) - std::int32_t(srgb_detail::kFirstBucket);
  const Ints carry = hn::GatherIndex(kI, kSrgbCarry.data(), bucket.v);
  return shifted_right<16>(carry + (bits & 0xffff));
}

HWY_INLINE Ints encode(Transfer transfer, Floats linear) {
  return transfer == Transfer::kSrgb ? encode_srgb(linear) : encode_unorm8(linear);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
