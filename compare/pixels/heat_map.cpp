#include <glassbox/compare/pixels/heat_map.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include <glassbox/images/palette.h>

namespace glassbox {
namespace {

struct Stop {
  int level;
  int r, g, b;
};
constexpr Stop kStops[] = {{1, 104, 48, 200},
                           {64, 200, 30, 120},
                           {128, 240, 84, 36},
                           {192, 255, 190, 40},
                           {254, 255, 255, 255}};
constexpr Rgba8 kNotComparedColour{62, 76, 96, 255};
constexpr Rgba8 kMovedEdgeColour{0, 160, 120, 255};
constexpr Rgba8 kBelowThresholdColour{0, 90, 170, 255};

std::uint8_t between(int a, int b, int numerator, int denominator) {
  return std::uint8_t(a + (b - a) * numerator / denominator);
}

// The end of the scale for floats, in ulps. Two floats that are so far apart differ by a factor of
// four.
constexpr std::uint32_t kFloatEnd = 1u << 24;

std::uint32_t end_of_scale(const StoredImage& image) {
  struct End {
    std::uint32_t operator()(const std::vector<std::uint8_t>&) const { return 255; }
    std::uint32_t operator()(const std::vector<std::uint16_t>&) const { return 65535; }
    std::uint32_t operator()(const std::vector<float>&) const { return kFloatEnd; }
  };
  return std::visit(End{}, image.samples);
}

// log2 in units of 1/256, linear between powers of two. It uses whole numbers, so that every
// machine gives the same picture.
std::uint32_t log2_256(std::uint32_t steps) {
  const auto exponent = std::uint32_t(std::bit_width(steps) - 1);
  return exponent * 256 + std::uint32_t((std::uint64_t(steps) << 8 >> exponent) - 256);
}

using Colours = std::array<Rgba8, 256>;

// The colours between the stops, from level 1 to the hottest.
const Colours& ramp() {
  static const Colours colours = [] {
    Colours table{};
    for (std::size_t i = 0; i + 1 < std::size(kStops); ++i) {
      const Stop& from = kStops[i];
      const Stop& to = kStops[i + 1];
      for (int level = from.level; level <= to.level; ++level) {
        const int done = level - from.level, all = to.level - from.level;
        table[std::size_t(level)] = {between(from.r, to.r, done, all),
                                     between(from.g, to.g, done, all),
                                     between(from.b, to.b, done, all), 255};
      }
    }
    return table;
  }();
  return colours;
}

// heat_level of one format, for up to 255 steps from a table.
class HeatLevels {
public:
  explicit HeatLevels(const StoredImage& image) : image_(image) {
    for (std::size_t steps = 0; steps < of_few_.size(); ++steps) {
      of_few_[steps] = heat_level(std::uint32_t(steps), image);
    }
  }
  std::uint8_t of(PixelKind kind, std::uint32_t steps) const {
    if (kind == PixelKind::kMovedEdge) return kHeatMovedEdge;
    if (kind == PixelKind::kBelowThreshold) return kHeatBelowThreshold;
    return steps < of_few_.size() ? of_few_[steps] : heat_level(steps, image_);
  }

private:
  const StoredImage& image_;
  std::array<std::uint8_t, 256> of_few_;
};

}  // namespace

const std::array<Rgba8, 256>& heat_colours() {
  static const Colours colours = [] {
    Colours table = ramp();
    table[kHeatNotCompared] = kNotComparedColour;
    table[kHeatMovedEdge] = kMovedEdgeColour;
    table[kHeatBelowThreshold] = kBelowThresholdColour;
    return table;
  }();
  return colours;
}

Rgba8 heat_colour(double share) {
  constexpr double kVisible = 0.15;
  const double inside = std::clamp(share, 0.0, 1.0);
  const Rgba8& colour = ramp()[std::size_t(1 + std::lround(inside * (kHeatHottest - 1)))];
  const double grown = std::min(inside / kVisible, 1.0);
  const auto part = [&](std::uint8_t full) { return std::uint8_t(std::lround(full * grown)); };
  return {part(colour.r), part(colour.g), part(colour.b), 255};
}

std::uint8_t heat_level(std::uint32_t steps, const StoredImage& image) {
  if (steps == 0) return kHeatSame;
  const std::uint32_t end = end_of_scale(image);
  const std::uint32_t height = log2_256(std::min(steps, end));
  return level_of_ramp(int(1 + height * (kHeatHottest - 1u) / log2_256(end)));
}

Image<std::uint8_t> heat_map(const PicturePair& pair) {
  const HeatLevels heat(pair.reference);
  Image<std::uint8_t> levels(pair.reference.width, pair.reference.height, kHeatSame);
  for (DifferenceRows rows(pair); rows.next();) {
    if (!rows.may_differ() && pair.selection.includes_all()) continue;  // kHeatSame everywhere
    const auto steps = rows.steps();
    const auto kinds = rows.kinds();
    for (int x = 0; x < levels.width; ++x) {
      const auto i = std::size_t(x);
      levels.at(x, rows.y()) =
          pair.selection.compares(x, rows.y()) ? heat.of(kinds[i], steps[i]) : kHeatNotCompared;
    }
  }
  return levels;
}

Image<Rgba8> heat_picture(const Image<std::uint8_t>& levels) {
  return coloured(levels, heat_colours());
}

}  // namespace glassbox
