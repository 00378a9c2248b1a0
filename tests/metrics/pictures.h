// Test pictures that are computed by formulas, and pairs of them.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/stored_image.h>

namespace glassbox::test {

// A byte that looks random; tests/metrics/reference/metrics.py computes the same one.
inline int noise(int x, int y, int channel, int seed) {
  std::uint32_t v = 0x9e3779b1u * std::uint32_t(x) + 0x85ebca77u * std::uint32_t(y) +
                    0xc2b2ae3du * std::uint32_t(channel) + 0x27d4eb2fu * std::uint32_t(seed);
  v = (v ^ (v >> 15)) * 0x2c1b3c6du;
  v = (v ^ (v >> 12)) * 0x297a2d39u;
  return int((v ^ (v >> 15)) >> 24);
}

// A picture whose samples are sample(x, y, channel).
template <class Sample, class Formula>
StoredImage picture(int width, int height, int channels, const Formula& sample) {
  std::vector<Sample> samples;
  samples.reserve(std::size_t(width) * std::size_t(height) * std::size_t(channels));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int channel = 0; channel < channels; ++channel) {
        samples.push_back(Sample(sample(x, y, channel)));
      }
    }
  }
  return {width, height, channels, std::move(samples)};
}

inline StoredImage noise_picture(int width, int height, int channels, int seed) {
  return picture<std::uint8_t>(width, height, channels,
                               [&](int x, int y, int c) { return noise(x, y, c, seed); });
}

// The same picture in 16 bits: 257 v / 65535 = v / 255.
inline StoredImage deepened(const StoredImage& image) {
  std::vector<std::uint16_t> samples;
  for (const std::uint8_t sample : std::get<std::vector<std::uint8_t>>(image.samples)) {
    samples.push_back(std::uint16_t(257 * sample));
  }
  return {image.width, image.height, image.channels, std::move(samples)};
}

inline StoredImage floats(int width, int height, int channels, std::vector<float> samples) {
  return {width, height, channels, std::move(samples)};
}

// Two pictures all of whose pixels are compared.
struct WholePair {
  StoredImage reference, test;
  Selection selection{reference.width, reference.height};
  bool nan_equals_nan = false;
  operator PicturePair() const { return {reference, test, selection, nan_equals_nan}; }
  WholePair swapped() const { return {test, reference, selection, nan_equals_nan}; }
};

}  // namespace glassbox::test
