#include <glassbox/compare/pixels/perceived_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include <glassbox/compare/pixels/alpha.h>

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
  if (has_alpha(channels)) colour.alpha = at(channels - 1);
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

// The squared distance of a pixel's colours over black or over white, where they are further apart.
template <class Sample>
double squared_distance(const Sample* reference, const Sample* test, int channels) {
  const CodedColour a = coded_colour(reference, channels), b = coded_colour(test, channels);
  const double over_white = squared_distance(over(a, 255), over(b, 255));
  if (a.alpha == 255 && b.alpha == 255) return over_white;
  return std::max(squared_distance(over(a, 0), over(b, 0)), over_white);
}

template <class Sample>
double distance_between(const Sample* reference, const Sample* test, int channels) {
  return std::sqrt(squared_distance(reference, test, channels) / kLargestSquare);
}
double distance_between(const float*, const float*, int) {
  return std::numeric_limits<double>::infinity();
}

// Calls use(x, distance) for those pixels of row y, from first_x to before end_x, that `wanted(x)`
// holds for.
template <class Wanted, class Use>
void visit_distances(const PicturePair& pair, int y, int first_x, int end_x, const Wanted& wanted,
                     const Use& use) {
  const int channels = pair.reference.channels;
  const std::size_t row = std::size_t(y) * std::size_t(pair.reference.width);
  std::visit(
      [&](const auto& reference) {
        const auto& test = std::get<std::decay_t<decltype(reference)>>(pair.test.samples);
        for (int x = first_x; x < end_x; ++x) {
          if (!wanted(x)) continue;
          const std::size_t at = (row + std::size_t(x)) * std::size_t(channels);
          use(x, distance_between(&reference[at], &test[at], channels));
        }
      },
      pair.reference.samples);
}

// The same for the pixels of row y that are kDifferent.
template <class Use>
void visit_distances(const PicturePair& pair, int y, std::span<const PixelKind> kinds,
                     const Use& use) {
  const auto differs = [&](int x) { return kinds[std::size_t(x)] == PixelKind::kDifferent; };
  visit_distances(pair, y, 0, int(kinds.size()), differs, use);
}

}  // namespace

double perceived_distance(const PicturePair& pair, PixelPosition pixel) {
  double found = 0;
  visit_distances(
      pair, pixel.y, pixel.x, pixel.x + 1, [](int) { return true; },
      [&](int, double distance) { found = distance; });
  return found;
}

void mark_below_threshold(const PicturePair& pair, int y, std::span<PixelKind> kinds) {
  visit_distances(pair, y, kinds, [&](int x, double distance) {
    if (distance <= *pair.set_aside.threshold) kinds[std::size_t(x)] = PixelKind::kBelowThreshold;
  });
}

double largest_distance(const PicturePair& pair) {
  double largest = 0;
  for (DifferenceRows rows(pair); rows.next();) {
    visit_distances(pair, rows.y(), rows.kinds(),
                    [&](int, double distance) { largest = std::max(largest, distance); });
  }
  return largest;
}

}  // namespace glassbox
