#include <glassbox/compare/report/page_thumbnail.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include <glassbox/compare/pixels/alpha.h>
#include <glassbox/compare/pixels/heat_map.h>

namespace glassbox {
namespace {

constexpr std::uint64_t kGround = 230;        // the grey under what is transparent
constexpr Rgba8 kFading{128, 128, 128, 255};  // mixed with the picture under a heat map

// How the boxes lie in the picture.
struct Grid {
  int width, height;  // of the picture, in px
  int columns, rows;  // of the thumbnail
  PixelBox box(int column, int row) const {
    const auto start = [](int i, int size, int count) {
      return int(std::int64_t(i) * size / count);
    };
    const int x = start(column, width, columns), y = start(row, height, rows);
    return {x, y, start(column + 1, width, columns) - x, start(row + 1, height, rows) - y};
  }
};

Grid grid_of(int width, int height) {
  const auto w = std::int64_t(width), h = std::int64_t(height);
  if (w * kThumbnailHeight > h * kThumbnailWidth) {
    const std::int64_t columns = std::min<std::int64_t>(w, kThumbnailWidth);
    return {width, height, int(columns), int(std::max<std::int64_t>(1, h * columns / w))};
  }
  const std::int64_t rows = std::min<std::int64_t>(h, kThumbnailHeight);
  return {width, height, int(std::max<std::int64_t>(1, w * rows / h)), int(rows)};
}

// The samples as values from 0 to 255 for every sample type.
struct Levels {
  float low = 0, high = 1;  // the finite range, for floats
  std::uint64_t operator()(std::uint8_t sample) const { return sample; }
  std::uint64_t operator()(std::uint16_t sample) const { return (sample + 128u) / 257u; }
  std::uint64_t operator()(float sample) const {
    if (!(sample > low)) return 0;
    if (sample >= high) return 255;
    const double share =
        (double(sample) - double(low)) / (double(high) - double(low));  // in (0, 1)
    return std::uint64_t(share * 255 + 0.5);
  }
};

template <class Sample>
Levels levels_of(const std::vector<Sample>& samples) {
  Levels levels;
  if constexpr (std::is_same_v<Sample, float>) {
    levels.low = std::numeric_limits<float>::infinity();
    levels.high = -levels.low;
    for (const float sample : samples) {
      if (!std::isfinite(sample)) continue;
      levels.low = std::min(levels.low, sample);
      levels.high = std::max(levels.high, sample);
    }
  }
  return levels;
}

// Returns the mean colour of a box.
template <class Sample>
Rgba8 mean_colour(const StoredImage& image, const std::vector<Sample>& samples,
                  const Levels& levels, const PixelBox& box) {
  const auto channels = std::size_t(image.channels);
  std::array<std::uint64_t, 3> sums{};
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) {
      const Sample* pixel =
          &samples[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * channels];
      const std::uint64_t alpha = has_alpha(image.channels) ? levels(pixel[channels - 1]) : 255;
      for (std::size_t i = 0; i < 3; ++i) {
        sums[i] += levels(pixel[channels < 3 ? 0 : i]) * alpha + kGround * (255 - alpha);
      }
    }
  }
  const std::uint64_t all = 255 * std::uint64_t(box.width) * std::uint64_t(box.height);
  const auto mean = [all](std::uint64_t sum) { return std::uint8_t((sum + all / 2) / all); };
  return {mean(sums[0]), mean(sums[1]), mean(sums[2]), 255};
}

// Differences are hotter than what is set aside, which is hotter than what is not compared.
int heat_rank(std::uint8_t level) {
  if (is_heat(level)) return 4 + level;
  constexpr std::array kRising{kHeatNotCompared, kHeatSame, kHeatBelowThreshold, kHeatMovedEdge};
  return int(std::find(kRising.begin(), kRising.end(), level) - kRising.begin());
}

std::uint8_t hotter(std::uint8_t a, std::uint8_t b) {
  return heat_rank(a) >= heat_rank(b) ? a : b;
}

// Returns the hottest level of each box.
Image<std::uint8_t> hottest_levels(const StoredImage& heat, const Grid& grid) {
  const auto& levels = std::get<std::vector<std::uint8_t>>(heat.samples);
  Image<std::uint8_t> hottest(grid.columns, grid.rows, kHeatNotCompared);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const PixelBox box = grid.box(column, row);
      std::uint8_t& found = hottest.at(column, row);
      for (int y = box.y; y < box.y + box.height; ++y) {
        const std::uint8_t* first =
            &levels[std::size_t(y) * std::size_t(heat.width) + std::size_t(box.x)];
        for (int x = 0; x < box.width; ++x) found = hotter(found, first[x]);
      }
    }
  }
  return hottest;
}

// Returns the box's own level, or that of a larger difference in the boxes around it.
std::uint8_t spread_level(const Image<std::uint8_t>& levels, int column, int row) {
  std::uint8_t found = levels.at(column, row);
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, levels.height - 1); ++y) {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, levels.width - 1); ++x) {
      if (is_heat(levels.at(x, y))) found = hotter(found, levels.at(x, y));
    }
  }
  return found;
}

Rgba8 half_way(Rgba8 a, Rgba8 b) {
  const auto half = [](int x, int y) { return std::uint8_t((x + y) / 2); };
  return {half(a.r, b.r), half(a.g, b.g), half(a.b, b.b), 255};
}

// Where more than a sixteenth of the boxes differ, spread colours would hide the picture.
bool is_sparse(const Image<std::uint8_t>& levels) {
  const auto hot = std::count_if(levels.pixels.begin(), levels.pixels.end(), is_heat);
  return 16 * std::size_t(hot) <= levels.pixels.size();
}

void lay_heat_over(Image<Rgba8>& thumbnail, const StoredImage& heat, const Grid& grid) {
  const Image<std::uint8_t> levels = hottest_levels(heat, grid);
  const bool sparse = is_sparse(levels);
  for (int y = 0; y < grid.rows; ++y) {
    for (int x = 0; x < grid.columns; ++x) {
      const std::uint8_t level = sparse ? spread_level(levels, x, y) : levels.at(x, y);
      Rgba8& pixel = thumbnail.at(x, y);
      const Rgba8 faded = half_way(pixel, kFading);
      const Rgba8 colour = heat_colours()[level];
      pixel = level == kHeatSame ? faded : sparse ? colour : half_way(pixel, colour);
    }
  }
}

const PagePicture* named(std::span<const PagePicture> pictures, std::string_view name) {
  const auto found = std::find_if(pictures.begin(), pictures.end(),
                                  [&](const PagePicture& one) { return one.name == name; });
  return found == pictures.end() ? nullptr : &*found;
}

}  // namespace

Image<Rgba8> page_thumbnail(std::span<const PagePicture> pictures) {
  const PagePicture* test = named(pictures, "test");
  const StoredImage& shown = *(test ? *test : pictures.front()).image;
  const Grid grid = grid_of(shown.width, shown.height);
  Image<Rgba8> thumbnail(grid.columns, grid.rows);
  std::visit(
      [&](const auto& samples) {
        const Levels levels = levels_of(samples);
        for (int y = 0; y < grid.rows; ++y) {
          for (int x = 0; x < grid.columns; ++x) {
            thumbnail.at(x, y) = mean_colour(shown, samples, levels, grid.box(x, y));
          }
        }
      },
      shown.samples);
  if (const PagePicture* heat = named(pictures, "heat")) {
    lay_heat_over(thumbnail, *heat->image, grid);
  }
  return thumbnail;
}

}  // namespace glassbox
