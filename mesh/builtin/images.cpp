#include <glassbox/mesh/builtin/images.h>

#include <algorithm>

#include <glassbox/base/random.h>

namespace glassbox {
namespace {

Rgba8 shaded(Rgba8 color, int offset) {
  const auto shift = [offset](std::uint8_t c) {
    return std::uint8_t(std::clamp(int(c) + offset, 0, 255));
  };
  return {shift(color.r), shift(color.g), shift(color.b), color.a};
}

// Returns a number in -amplitude .. amplitude.
int random_offset(std::uint64_t seed, std::uint64_t index, int amplitude) {
  return int(scramble(scramble(seed) + index) % std::uint64_t(2 * amplitude + 1)) - amplitude;
}

}  // namespace

std::uint64_t scramble(std::uint64_t x) {
  return Random(x).bits();
}

double random_unit(std::uint64_t seed, std::uint64_t index) {
  return Random(scramble(seed) + index).unit();
}

Image<Rgba8> make_checks(int cells, int cell_px, Rgba8 first, Rgba8 second) {
  Image<Rgba8> image(cells * cell_px, cells * cell_px);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      image.at(x, y) = (x / cell_px + y / cell_px) % 2 == 0 ? first : second;
    }
  }
  return image;
}

Image<Rgba8> make_noise(int side_px, Rgba8 color, int amplitude, std::uint64_t seed) {
  Image<Rgba8> image(side_px, side_px);
  for (int y = 0; y < side_px; ++y) {
    for (int x = 0; x < side_px; ++x) {
      // The noise has two sizes of grain: patches of 8 x 8 px, and single pixels.
      const auto patch = std::uint64_t((y / 8) * side_px + x / 8);
      const auto pixel = std::uint64_t(y * side_px + x);
      const int offset =
          random_offset(seed, patch, amplitude) + random_offset(seed + 1, pixel, amplitude);
      image.at(x, y) = shaded(color, offset / 2);
    }
  }
  return image;
}

Image<Rgba8> make_boards(Rgba8 color, std::uint64_t seed) {
  constexpr int kSide = 128, kBoard = 16;
  Image<Rgba8> image(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    const int board = y / kBoard;
    // The x coordinate of the joint where the two ends of the board meet; the board goes on from
    // the right edge of the image to the left one.
    const int end = int(scramble(seed + std::uint64_t(board)) % kSide);
    for (int x = 0; x < kSide; ++x) {
      const bool joint = y % kBoard == 0 || x == end;
      const int shade = random_offset(seed, std::uint64_t(board), 22);
      const int grain = random_offset(seed + 7, std::uint64_t((y * kSide + x) / 8), 9);
      image.at(x, y) = shaded(color, joint ? -60 : shade + grain);
    }
  }
  return image;
}

}  // namespace glassbox
