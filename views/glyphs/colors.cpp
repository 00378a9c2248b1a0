#include "views/glyphs/colors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glassbox/images/colour/power.h>
#include <glassbox/images/srgb.h>

namespace glassbox::views {

namespace {

Eigen::Array3f array_of(const Rgba8& color) {
  return {float(color.r), float(color.g), float(color.b)};
}

// For each prototype, the distance to the nearest other prototype.
const std::array<float, kPrototypes>& reaches() {
  static const auto all = [] {
    std::array<float, kPrototypes> nearest{};
    for (std::size_t i = 0; i < kPrototypes; ++i) {
      nearest[i] = std::numeric_limits<float>::infinity();
      for (std::size_t k = 0; k < kPrototypes; ++k) {
        if (i == k) continue;
        const Eigen::Array3f apart = array_of(kPrototypeColors[i]) - array_of(kPrototypeColors[k]);
        nearest[i] = std::min(nearest[i], apart.matrix().norm());
      }
    }
    return nearest;
  }();
  return all;
}

// A quantile: the value that the fraction `share` of the values is below. Reorders the values.
float at_share(std::vector<float>& values, double share) {
  const auto place = std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[std::size_t(place)];
}

}  // namespace

Light light_of(const Rgba8& color) {
  return {decode_srgb(color.r), decode_srgb(color.g), decode_srgb(color.b)};
}

int prototype_of(const Eigen::Array3f& codes, float threshold) {
  int nearest = kNoPrototype;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < kPrototypes; ++i) {
    const float distance = (codes - array_of(kPrototypeColors[i])).matrix().squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = int(i);
    }
  }
  if (nearest == kNoPrototype) return nearest;
  return std::sqrt(least) < threshold * reaches()[std::size_t(nearest)] ? nearest : kNoPrototype;
}

// The sRGB curve of IEC 61966-2-1. It is only used for classification, not for drawing.
Eigen::Array3f codes_of(const Light& light) {
  return light.unaryExpr([](float value) {
    const float clamped = std::clamp(value, 0.0f, 1.0f);
    return 255 *
           (clamped <= 0.0031308f ? 12.92f * clamped : 1.055f * power(clamped, 1 / 2.4f) - 0.055f);
  });
}

Light paper_of(const Image<Rgba8>& picture) {
  std::vector<float> darkest;
  darkest.reserve(picture.pixels.size());
  const auto darkest_of = [](const Rgba8& pixel) {
    return decode_srgb(std::min({pixel.r, pixel.g, pixel.b}));
  };
  for (const Rgba8& pixel : picture.pixels) darkest.push_back(darkest_of(pixel));
  constexpr double kBrightest = 0.95;
  constexpr float kAsBright = 0.8f;
  const float bright = kAsBright * at_share(darkest, kBrightest);
  std::array<std::vector<float>, 3> channels;
  for (const Rgba8& pixel : picture.pixels) {
    if (darkest_of(pixel) < bright) continue;
    channels[0].push_back(decode_srgb(pixel.r));
    channels[1].push_back(decode_srgb(pixel.g));
    channels[2].push_back(decode_srgb(pixel.b));
  }
  static constexpr float kLeast = 1e-3f;  // a black picture has no paper
  const auto median = [](std::vector<float>& values) {
    return std::max(at_share(values, 0.5), kLeast);
  };
  return {median(channels[0]), median(channels[1]), median(channels[2])};
}

}  // namespace glassbox::views
