// Writes models of COLMAP, as text and in binary (colmap.github.io/format.html).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace glassbox::views::test {

struct ModelLens {
  std::int32_t id = 1;
  std::int32_t kind = 1;  // PINHOLE
  std::uint64_t width = 64, height = 48;
  std::vector<double> parameters{50, 51, 32, 24};
};

struct ModelPicture {
  std::string name;
  std::array<double, 4> turn{1, 0, 0, 0};
  std::array<double, 3> shift{0, 0, 4};
  std::int32_t lens = 1;
  std::size_t points = 1;
};

struct Model {
  std::vector<ModelLens> lenses{{}};
  std::vector<ModelPicture> pictures;
};

struct ModelFiles {
  std::string cameras, images;
};

inline constexpr std::string_view kLensNames[] = {"SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL",
                                                  "RADIAL",         "OPENCV",  "OPENCV_FISHEYE",
                                                  "FULL_OPENCV",    "FOV"};

inline ModelFiles text_of(const Model& model) {
  ModelFiles files{"# Camera list\n", "# Image list\n"};
  for (const auto& [id, kind, width, height, parameters] : model.lenses) {
    files.cameras += fmt::format("{} {} {} {} {}\n", id, kLensNames[kind], width, height,
                                 fmt::join(parameters, " "));
  }
  std::int32_t number = 0;
  for (const auto& [name, turn, shift, lens, points] : model.pictures) {
    files.images += fmt::format("{} {} {} {} {}\n", ++number, fmt::join(turn, " "),
                                fmt::join(shift, " "), lens, name);
    for (std::size_t i = 0; i < points; ++i) files.images += "1.5 2.5 -1 ";
    files.images += "\n";
  }
  return files;
}

// Appends the bytes of a number, the lowest first.
inline void put(std::string& bytes, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes += char(value >> 8 * i);
}
inline void put(std::string& bytes, std::span<const double> numbers) {
  for (const double number : numbers) put(bytes, std::bit_cast<std::uint64_t>(number), 8);
}

inline ModelFiles binary_of(const Model& model) {
  ModelFiles files;
  put(files.cameras, model.lenses.size(), 8);
  for (const auto& [id, kind, width, height, parameters] : model.lenses) {
    put(files.cameras, std::uint32_t(id), 4);
    put(files.cameras, std::uint32_t(kind), 4);
    put(files.cameras, width, 8);
    put(files.cameras, height, 8);
    put(files.cameras, parameters);
  }
  put(files.images, model.pictures.size(), 8);
  std::uint32_t number = 0;
  for (const auto& [name, turn, shift, lens, points] : model.pictures) {
    put(files.images, ++number, 4);
    put(files.images, turn);
    put(files.images, shift);
    put(files.images, std::uint32_t(lens), 4);
    files.images += name + '\0';
    put(files.images, points, 8);
    for (std::size_t i = 0; i < points; ++i) {
      put(files.images, std::array{1.5, 2.5});
      put(files.images, ~std::uint64_t(0), 8);  // of no point in space
    }
  }
  return files;
}

}  // namespace glassbox::views::test
