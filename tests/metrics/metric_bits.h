// The metrics of generated pairs, to compare two programs that compute them.
#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include <glassbox/base/random.h>
#include <glassbox/compare/metrics/flip.h>
#include <glassbox/compare/metrics/ssim.h>

#include "tests/metrics/pictures.h"

namespace glassbox::test {

// Writes FLIP and SSIM of 60 pairs of random sizes, channels and formats, a line each. Doubles are
// hexadecimal, so that no bit is lost. The sizes pass a tile's in both directions.
inline std::string metric_bits() {
  std::string lines;
  Random random(69);
  const auto number = [&random](int low, int high) { return int(random.integer(low, high)); };
  for (int i = 0; i < 60; ++i) {
    const int width = number(1, 180), height = number(1, 80), channels = number(1, 4);
    StoredImage reference = noise_picture(width, height, channels, 2 * i);
    StoredImage other = noise_picture(width, height, channels, 2 * i + 1);
    if (i % 3 == 0) {
      reference = deepened(reference);
      other = deepened(other);
    }
    const WholePair pair{std::move(reference), std::move(other)};
    const FlipErrors errors = flip(pair);
    const SsimValues values = ssim(pair);
    lines += fmt::format("{} x {} x {}: flip {:a} {:a} {:a} {:a}, ssim {:a} {:a}\n", width, height,
                         channels, errors.mean, errors.median, errors.p95, errors.max, values.mean,
                         values.min);
  }
  return lines;
}

}  // namespace glassbox::test
