#include "views/features/bit_descriptor.h"

#include <bit>
#include <cmath>

#include "views/features/scale_level.h"

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>

namespace glassbox::views {

namespace {

double normal(Random& random) {
  double sum = 0;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum - 6;
}

std::array<double, 2> place(Random& random) {
  for (;;) {
    const double x = kPatternSigma * normal(random);
    const double y = kPatternSigma * normal(random);
    if (x * x + y * y <= kPatternRadius * kPatternRadius) return {x, y};
  }
}

BitPattern make_pattern() {
  Random random(kPatternSeed);
  BitPattern pattern{};
  for (std::array<double, 4>& pair : pattern) {
    double square = 0;
    while (square < kLeastApart * kLeastApart) {
      const auto first = place(random);
      const auto second = place(random);
      pair = {first[0], first[1], second[0], second[1]};
      const double dx = second[0] - first[0], dy = second[1] - first[1];
      square = dx * dx + dy * dy;
    }
  }
  return pattern;
}

}  // namespace

const BitPattern& bit_pattern() {
  static const BitPattern pattern = make_pattern();
  return pattern;
}

double centroid_angle(const Image<float>& grey, double x, double y) {
  double sum_x = 0, sum_y = 0;
  for (int dy = -kCentroidRadius; dy <= kCentroidRadius; ++dy) {
    for (int dx = -kCentroidRadius; dx <= kCentroidRadius; ++dx) {
      if (dx * dx + dy * dy > kCentroidRadius * kCentroidRadius) continue;
      const double value = grey_at(grey, x + dx, y + dy);
      sum_x += dx * value;
      sum_y += dy * value;
    }
  }
  return arctan2(sum_y, sum_x);
}

BitDescriptor bit_descriptor(const Image<float>& grey, double x, double y, double angle) {
  const SinCos turn = sin_cos(angle);
  const auto value = [&](double along, double across) {
    return grey_at(grey, x + (turn.cos * along - turn.sin * across),
                   y + (turn.sin * along + turn.cos * across));
  };
  BitDescriptor bits{};
  for (std::size_t i = 0; i < bit_pattern().size(); ++i) {
    const auto& [x1, y1, x2, y2] = bit_pattern()[i];
    const bool is_darker = value(x1, y1) < value(x2, y2);
    bits[i / 64] |= std::uint64_t(is_darker) << (i % 64);
  }
  return bits;
}

double distance(const BitDescriptor& a, const BitDescriptor& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += std::popcount(a[i] ^ b[i]);
  return count;
}

}  // namespace glassbox::views
