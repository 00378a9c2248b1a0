// Makes pictures in every kind of file that glassbox diff compares.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <stb/stb_image_write.h>

#include "tests/app/text.h"
#include "tests/compare/pictures.h"
#include "tests/images/png_builder.h"

#include <glassbox/images/write.h>

namespace glassbox::test {

inline std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <class T>
T value_of(const Result<T>& result) {
  if (!result) throw std::runtime_error(result.error().message());
  return *result;
}

inline std::string png_of(const StoredImage& image, std::span<const TextEntry> text = {}) {
  return text_of(value_of(encode_png(image, text)));
}

inline std::string pfm_of(const StoredImage& image) {
  return text_of(value_of(encode_pfm(image)));
}

// Returns a PPM or PGM file. Samples of 16 bits have the high byte first.
inline std::string pnm_of(const StoredImage& image) {
  const bool wide = std::holds_alternative<std::vector<std::uint16_t>>(image.samples);
  std::string text = std::string(image.channels == 3 ? "P6" : "P5") + "\n" +
                     std::to_string(image.width) + " " + std::to_string(image.height) + "\n" +
                     (wide ? "65535" : "255") + "\n";
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        const int value = int(sample_at(image, x, y, c));
        if (wide) text += char(value >> 8);
        text += char(value & 255);
      }
    }
  }
  return text;
}

// Returns a PNG with a palette of the RGB picture's colours, in the order of their first pixels.
inline std::string palette_png_of(const StoredImage& image) {
  PngParts parts;
  parts.width = std::uint32_t(image.width);
  parts.height = std::uint32_t(image.height);
  parts.colour_type = 3;
  for (int y = 0; y < image.height; ++y) {
    parts.rows.push_back(0);
    for (int x = 0; x < image.width; ++x) {
      std::size_t entry = 0;
      const auto is = [&](std::size_t i) {
        for (int c = 0; c < 3; ++c) {
          if (parts.palette[3 * i + std::size_t(c)] != sample_at(image, x, y, c)) return false;
        }
        return true;
      };
      while (3 * entry < parts.palette.size() && !is(entry)) ++entry;
      if (3 * entry == parts.palette.size()) {
        for (int c = 0; c < 3; ++c) {
          parts.palette.push_back(std::uint8_t(sample_at(image, x, y, c)));
        }
      }
      if (entry > 255) throw std::runtime_error("too many colours for a palette");
      parts.rows.push_back(std::uint8_t(entry));
    }
  }
  const Bytes bytes = build_png(parts);
  return {bytes.begin(), bytes.end()};
}

inline std::string jpeg_of(const StoredImage& image) {
  std::string text;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), std::size_t(size));
  };
  const auto& samples = std::get<std::vector<std::uint8_t>>(image.samples);
  constexpr int kBestQuality = 100;
  if (!::stbi_write_jpg_to_func(append, &text, image.width, image.height, image.channels,
                                samples.data(), kBestQuality)) {
    throw std::runtime_error("no JPEG written");
  }
  return text;
}

struct PictureFileKind {
  std::string name, extension;
  int channels = 0;
  Format format = Format::kBytes;
  std::function<std::string(const StoredImage&)> encode;
  bool exact = true;  // the file is read back as it was written
};

inline std::vector<PictureFileKind> all_kinds() {
  const auto png = [](const StoredImage& image) { return png_of(image); };
  return {{"grey PNG", ".png", 1, Format::kBytes, png},
          {"grey and alpha PNG", ".png", 2, Format::kBytes, png},
          {"RGB PNG", ".png", 3, Format::kBytes, png},
          {"RGBA PNG", ".png", 4, Format::kBytes, png},
          {"palette PNG", ".png", 3, Format::kBytes, palette_png_of},
          {"grey PNG of 16 bits", ".png", 1, Format::kShorts, png},
          {"RGB PNG of 16 bits", ".png", 3, Format::kShorts, png},
          {"RGBA PNG of 16 bits", ".png", 4, Format::kShorts, png},
          {"JPEG", ".jpg", 3, Format::kBytes, jpeg_of, false},
          {"grey JPEG", ".jpeg", 1, Format::kBytes, jpeg_of, false},
          {"PPM", ".ppm", 3, Format::kBytes, pnm_of},
          {"PGM", ".pgm", 1, Format::kBytes, pnm_of},
          {"PPM of 16 bits", ".ppm", 3, Format::kShorts, pnm_of},
          {"grey PFM", ".pfm", 1, Format::kFloats, pfm_of},
          {"RGB PFM", ".pfm", 3, Format::kFloats, pfm_of}};
}

// Returns a picture with few enough colours for a palette, without symmetry, and with room for a
// step at both ends of the range.
inline StoredImage sample_picture(const PictureFileKind& kind, int width = 24, int height = 18) {
  StoredImage image = blank(width, height, kind.channels, kind.format);
  const double scale = kind.format == Format::kShorts   ? 257
                       : kind.format == Format::kFloats ? 0.01
                                                        : 1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int shade = 20 + (x * x + 3 * x * y + 5 * y) % 31 * 7;
      for (int c = 0; c < kind.channels; ++c) {
        set_sample(image, x, y, c, scale * ((shade + 5 * c * shade) % 230 + 10));
      }
    }
  }
  return image;
}

// Increases every sample by one step.
inline StoredImage one_step_up(StoredImage image) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        const double value = sample_at(image, x, y, c);
        const bool is_float = std::holds_alternative<std::vector<float>>(image.samples);
        const double next =
            is_float ? double(std::bit_cast<float>(std::bit_cast<std::uint32_t>(float(value)) + 1))
                     : value + 1;
        set_sample(image, x, y, c, next);
      }
    }
  }
  return image;
}

// Shifts the picture by one pixel to the right; the first column then occurs twice.
inline StoredImage shifted(const StoredImage& image) {
  StoredImage result = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        set_sample(result, x, y, c, sample_at(image, std::max(x - 1, 0), y, c));
      }
    }
  }
  return result;
}

}  // namespace glassbox::test
