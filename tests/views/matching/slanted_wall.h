// A slanted wall with a smooth texture, whose disparities are known to a fraction of a pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

// The disparity c + a x + b y at column x and row y of the left picture.
struct Slant {
  double c, a, b;
};

struct SlantedWall {
  Image<Rgba8> left, right;
  Image<float> disparity;         // of the left picture
  Image<std::uint8_t> is_inside;  // pixels whose windows are inside both pictures
};

// The texture is a sum of forty waves of 4 to 20 px in any direction. The right picture shows at
// column x - d what the left picture shows at x.
inline SlantedWall slanted_wall(int width, int height, const Slant& slant, std::uint64_t seed) {
  constexpr int kWaves = 40;
  constexpr int kReach = 10;  // px: the reach of windows and of filters
  Random random(seed);
  struct Wave {
    double x, y, phase;
  };
  std::vector<Wave> waves;
  for (int i = 0; i < kWaves; ++i) {
    const double angle = random.between(0, 2 * std::numbers::pi);
    const double speed = 2 * std::numbers::pi / random.between(4, 20);
    waves.push_back({speed * std::cos(angle), speed * std::sin(angle),
                     random.between(0, 2 * std::numbers::pi)});
  }
  const auto color = [&](double x, double y) {
    double sum = 0;
    for (const Wave& wave : waves) sum += std::sin(wave.x * x + wave.y * y + wave.phase);
    const auto grey = std::uint8_t(std::lround(std::clamp(128 + 17 * sum, 0.0, 255.0)));
    return Rgba8{grey, grey, grey, 255};
  };
  SlantedWall wall{{width, height}, {width, height}, {width, height}, {width, height, 0}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      wall.left.at(x, y) = color(x, y);
      wall.right.at(x, y) = color((x + slant.c + slant.b * y) / (1 - slant.a), y);
      const double d = slant.c + slant.a * x + slant.b * y;
      wall.disparity.at(x, y) = float(d);
      wall.is_inside.at(x, y) = x >= kReach && x < width - kReach && y >= kReach &&
                                y < height - kReach && x - d >= kReach && x - d < width - kReach;
    }
  }
  return wall;
}

}  // namespace glassbox::views
