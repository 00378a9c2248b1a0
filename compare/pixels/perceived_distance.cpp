#include <glassbox/compare/pixels/perceived_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace glassbox {
namespace {

// A colour as it is stored, and its alpha, all in [0, 255].
struct CodedColour {
  double r = 0, g = 0, b = 0;
  double alpha = 255;
};

template <class Sample>
CodedColour coded_colour(const Sample* samples, int channels) {
  constexpr double kUnit = std::is_same_v<Sample, std::uint8_t> ? 1 : 257;
  const bool grey = channels < 3;
  const auto at = [&](int channel) { return double(samples[channel]) / kUnit; };
  CodedColour colour{at(0), at(grey ? 0 : 1), at(grey ? 0 : 2)};
  if (channels % 2 == 0) colour.alpha = at(channels - 1);
  return colour;
}

CodedColour over(const CodedColour& colour, double background) {
  if (colour.alpha == 255) return colour;
  const double share = colour.alpha / 255;
  const auto blend = [&](double value) { return background + (value - background) * share; };
  return {blend(colour.r), blend(colour.g), blend(colour.b)};
}

double squared_distance(const CodedColour& a, const CodedColour& b) {
  const double r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b;
  const double y = r * 0.29889531 + g * 0.58662247 + blue * 0.11448223;
  const double i = r * 0.59597799 - g * 0.27417610 - blue * 0.32180189;
  const double q = r * 0.21147017 - g * 0.52261711 + blue * 0.31114694;
  return 0.5053 * y * y + 0.299 * i * i + 0.1957 * q * q;
}

// The largest squared distance of two opaque colours.
constexpr double kLargestSquare = 35215;

}  // namespace

double perceived_distance(const PicturePair& pair, PixelPosition pixel) {
  const int channels = pair.reference.channels;
  const std::size_t first =
      (std::size_t(pixel.y) * std::size_t(pair.reference.width) + std::size_t(pixel.x)) *
      std::size_t(channels);
  return std::visit(
      [&](const auto& samples) {
        using Samples = std::decay_t<decltype(samples)>;
        if constexpr (std::is_same_v<Samples, std::vector<float>>) {
          return std::numeric_limits<double>::infinity();
        } else {
          const CodedColour a = coded_colour(samples.data() + first, channels);
          const CodedColour b =
              coded_colour(std::get<Samples>(pair.test.samples).data() + first, channels);
          const double square = std::max(squared_distance(over(a, 0), over(b, 0)),
                                         squared_distance(over(a, 255), over(b, 255)));
          return std::sqrt(square / kLargestSquare);
        }
      },
      pair.reference.samples);
}

double largest_distance(const PicturePair& pair) {
  std::vector<std::uint32_t> steps(std::size_t(pair.reference.width));
  std::vector<PixelKind> kinds(steps.size());
  double largest = 0;
  for (int y = 0; y < pair.reference.height; ++y) {
    if (!row_differences(pair, y, steps)) continue;
    row_kinds(pair, y, steps, kinds);
    for (int x = 0; x < pair.reference.width; ++x) {
      if (kinds[std::size_t(x)] != PixelKind::kDifferent) continue;
      largest = std::max(largest, perceived_distance(pair, {x, y}));
    }
  }
  return largest;
}

}  // namespace glassbox
