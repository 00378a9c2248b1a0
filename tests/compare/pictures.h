// Makes pictures for the tests of the comparison.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/stored_image.h>

namespace glassbox::test {

enum class Format : std::uint8_t { kBytes, kShorts, kFloats };
inline constexpr Format kFormats[] = {Format::kBytes, Format::kShorts, Format::kFloats};

// Returns a picture whose samples are all zero.
inline StoredImage blank(int width, int height, int channels, Format format) {
  StoredImage image{width, height, channels, {}};
  const std::size_t count = image.pixels() * std::size_t(channels);
  if (format == Format::kBytes) image.samples = std::vector<std::uint8_t>(count);
  if (format == Format::kShorts) image.samples = std::vector<std::uint16_t>(count);
  if (format == Format::kFloats) image.samples = std::vector<float>(count);
  return image;
}

inline std::size_t sample_index(const StoredImage& image, int x, int y, int channel) {
  const auto pixel = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
  return pixel * std::size_t(image.channels) + std::size_t(channel);
}

// Returns a sample of any of the three formats; a double holds each of them exactly.
inline double sample_at(const StoredImage& image, int x, int y, int channel) {
  return std::visit(
      [&](const auto& samples) { return double(samples[sample_index(image, x, y, channel)]); },
      image.samples);
}

inline void set_sample(StoredImage& image, int x, int y, int channel, double value) {
  std::visit(
      [&](auto& samples) {
        using Sample = typename std::decay_t<decltype(samples)>::value_type;
        samples[sample_index(image, x, y, channel)] = Sample(value);
      },
      image.samples);
}

// Returns a random number that the format can hold: any byte, any 16 bits, or a float in [-2, 2)
// with a fraction of 12 bits.
inline double random_sample(Random& random, Format format) {
  if (format == Format::kBytes) return double(random.integer(0, 255));
  if (format == Format::kShorts) return double(random.integer(0, 65535));
  return double(random.integer(-8192, 8191)) / 4096;
}

inline StoredImage random_picture(Random& random, int width, int height, int channels,
                                  Format format) {
  StoredImage image = blank(width, height, channels, format);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < channels; ++c) {
        set_sample(image, x, y, c, random_sample(random, format));
      }
    }
  }
  return image;
}

// The part of a picture in a box that lies within it, in a format that holds its samples.
inline StoredImage part_of(const StoredImage& image, const PixelBox& box, Format format) {
  StoredImage part = blank(box.width, box.height, image.channels, format);
  for (int y = 0; y < box.height; ++y) {
    for (int x = 0; x < box.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        set_sample(part, x, y, c, sample_at(image, box.x + x, box.y + y, c));
      }
    }
  }
  return part;
}

// Reads a picture of the repository by its name in images/golden.
inline StoredImage golden(const std::string& name) {
  auto image = read_stored(std::string(GLASSBOX_SOURCE_DIR) + "/images/golden/" + name);
  if (!image) throw std::runtime_error(image.error().message());
  return *std::move(image);
}

inline const char* name_of(Format format) {
  constexpr const char* kNames[] = {"8 bits", "16 bits", "floats"};
  return kNames[std::size_t(format)];
}

}  // namespace glassbox::test
