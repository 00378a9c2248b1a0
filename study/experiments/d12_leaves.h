// A picture with the statistics of photographs that is computed from random numbers only (D-12).
//
// Dead leaves (Matheron 1968; Lee, Mumford and Huang 2001): discs that fall on each other, with
// radii r distributed as r^-3, so that the picture looks the same at every scale: edges are rare
// and sharp, and surfaces between them are plain. The colours have the distribution that Ruderman,
// Cronin and Chiao (1998) found outdoors: the logarithm of the light is normally distributed and
// varies several times as much as yellow to blue, which in turn varies several times as much as red
// to green.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glassbox/base/random.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stereo/linear.h>

namespace glassbox::study::d12 {

// Returns the picture in linear light. The radii of the discs are from 1 px to half the width.
inline Image<Linear> make_leaves(int width, int height, std::uint64_t seed) {
  constexpr double kLight = 0.8, kYellowBlue = 0.25, kRedGreen = 0.12, kMiddle = 0.18;
  Random random(seed);
  // The sum of three uniform numbers has a standard deviation of 1 and is nearly normal.
  const auto normal = [&] {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += random.between(-1, 1);
    return sum;
  };
  const double least = 1, most = width / 2.0;
  Image<Linear> picture(width, height, Linear{});
  Image<std::uint8_t> covered(width, height, 0);
  int left = width * height;
  // The first disc is on top: a pixel that has a colour keeps it.
  while (left > 0) {
    const double u = random.unit();
    const double radius = 1 / std::sqrt(u / (least * least) + (1 - u) / (most * most));
    const double x = random.between(-most, width + most), y = random.between(-most, height + most);
    const double light = std::log(kMiddle) + kLight * normal(), yellow = kYellowBlue * normal(),
                 red = kRedGreen * normal();
    // Rounds to steps of 2^-12, because the last digit of exp differs between libraries.
    const auto channel = [&](double logarithm) {
      return float(std::min(1.0, std::floor(std::exp(light + logarithm) * 0x1p12 + 0.5) * 0x1p-12));
    };
    const Linear colour{channel(yellow / 2 + red), channel(yellow / 2 - red), channel(-yellow)};
    const int x0 = std::max(0, int(std::ceil(x - radius - 0.5))),
              x1 = std::min(width, int(std::floor(x + radius - 0.5)) + 1),
              y0 = std::max(0, int(std::ceil(y - radius - 0.5))),
              y1 = std::min(height, int(std::floor(y + radius - 0.5)) + 1);
    for (int j = y0; j < y1; ++j) {
      for (int i = x0; i < x1; ++i) {
        const double dx = i + 0.5 - x, dy = j + 0.5 - y;
        if (covered.at(i, j) != 0 || dx * dx + dy * dy > radius * radius) continue;
        covered.at(i, j) = 1, picture.at(i, j) = colour, --left;
      }
    }
  }
  return picture;
}

}  // namespace glassbox::study::d12
