// Makes pictures as they are stored in files, for tests: random ones, and the PNGs that hold them.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/images/stored_image.h>

#include "tests/images/png_builder.h"

namespace glassbox::test {

template <class Sample>
StoredImage stored(int width, int height, int channels, std::vector<Sample> samples) {
  return {width, height, channels, std::move(samples)};
}

// Returns samples with random bits: floats include NaN with every payload.
template <class Sample>
StoredImage random_stored(int width, int height, int channels, Random& random) {
  std::vector<Sample> samples(std::size_t(width) * std::size_t(height) * std::size_t(channels));
  for (Sample& sample : samples) {
    const std::uint64_t bits = random.bits();
    std::memcpy(&sample, &bits, sizeof sample);
  }
  return stored(width, height, channels, std::move(samples));
}

// Like ==, but compares the bits of floats.
inline bool same_bits(const StoredImage& a, const StoredImage& b) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels) return false;
  return std::visit(
      [&]<class Sample>(const std::vector<Sample>& samples) {
        const auto* others = std::get_if<std::vector<Sample>>(&b.samples);
        return others && others->size() == samples.size() &&
               std::memcmp(others->data(), samples.data(), samples.size() * sizeof(Sample)) == 0;
      },
      a.samples);
}

// Appends the samples of pixel (x, y) as a PNG stores them: 16 bits with the high byte first.
inline void put_pixel(Bytes& row, const StoredImage& image, int x, int y) {
  const auto channels = std::size_t(image.channels);
  const std::size_t first = (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * channels;
  for (std::size_t i = first; i < first + channels; ++i) {
    if (const auto* wide = std::get_if<std::vector<std::uint16_t>>(&image.samples)) {
      row.push_back(std::uint8_t((*wide)[i] >> 8));
      row.push_back(std::uint8_t((*wide)[i]));
    } else {
      row.push_back(std::get<std::vector<std::uint8_t>>(image.samples)[i]);
    }
  }
}

// Returns an unfiltered PNG of 8 or 16 bits, built without libpng. An interlaced one has the seven
// passes of Adam7.
inline Bytes build_stored_png(const StoredImage& image, bool interlaced) {
  struct Pass {
    int x, y, step_x, step_y;
  };
  static constexpr Pass kPasses[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                     {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  static constexpr Pass kWhole[] = {{0, 0, 1, 1}};
  Bytes rows;
  for (const Pass& pass : interlaced ? std::span<const Pass>(kPasses) : kWhole) {
    if (pass.x >= image.width) continue;
    for (int y = pass.y; y < image.height; y += pass.step_y) {
      rows.push_back(0);
      for (int x = pass.x; x < image.width; x += pass.step_x) put_pixel(rows, image, x, y);
    }
  }
  static constexpr std::uint8_t kColourTypes[] = {0, 4, 2, 6};
  return build_png({.width = std::uint32_t(image.width),
                    .height = std::uint32_t(image.height),
                    .bit_depth = std::uint8_t(image.samples.index() == 1 ? 16 : 8),
                    .colour_type = kColourTypes[image.channels - 1],
                    .rows = rows,
                    .interlaced = interlaced});
}

}  // namespace glassbox::test
