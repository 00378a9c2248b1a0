// A pixel's colour as the mean of its samples' colours.
#pragma once

#include <span>

#include <glassbox/images/image.h>
#include <glassbox/raster/transfer.h>

namespace glassbox {

// The mean of 1, 2, 4, 8 or 16 stored colours. With kSrgb it is the mean of their light, with kNone
// the mean of the bytes; alpha is always the mean of the bytes.
//
// Bytes: (2 sum + count) / (2 count) rounded down, which is the nearest byte, halves up.
// Light: decode_srgb gives multiples of 2^-35 (floats of at least 2^-12, or 0), and 16 of them sum
// to at most 16. So the sum has at most 39 bits and is exact in a double, in any order; so is its
// quotient by a power of two. It is rounded once, to float, by at most 2^-24 of the value, and
// encode_srgb gives the byte nearest to that. The mean of equal colours is that colour, because
// then nothing is rounded.
inline Rgba8 mean_color(Transfer transfer, std::span<const Rgba8> samples) {
  const unsigned count = unsigned(samples.size());
  using Channel = std::uint8_t Rgba8::*;
  const auto mean_byte = [&](Channel channel) {
    unsigned sum = 0;
    for (const Rgba8& one : samples) sum += one.*channel;
    return std::uint8_t((2 * sum + count) / (2 * count));
  };
  const auto mean = [&](Channel channel) {
    if (transfer == Transfer::kNone) return mean_byte(channel);
    double sum = 0;
    for (const Rgba8& one : samples) sum += double(decode_srgb(one.*channel));
    return encode_srgb(float(sum / double(count)));
  };
  return {mean(&Rgba8::r), mean(&Rgba8::g), mean(&Rgba8::b), mean_byte(&Rgba8::a)};
}

}  // namespace glassbox
