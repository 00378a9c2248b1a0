// The light of a screen that each eye sees through its lens.
#pragma once

#include <array>

#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/images/stereo/linear.h>

namespace glassbox {

// CIE X, Y, Z (rows) of the light of the screen's red, green and blue (columns).
using LightMatrix = std::array<std::array<double, 3>, 3>;

struct Lenses {
  LightMatrix left, right;
  bool measured = false;  // true: with the measured leaks of a real pair of glasses
};

// The light of the screen without glasses (C), and behind the left and the right lens of red-cyan
// glasses (A_l and A_r), as McAllister, Zhou and Sullivan, "Methods for computing color anaglyphs"
// (2010), took it from Dubois.
inline constexpr LightMatrix kScreenLight{
    {{0.4243, 0.3105, 0.1657}, {0.2492, 0.6419, 0.1089}, {0.0265, 0.1225, 0.8614}}};
inline constexpr LightMatrix kRedLensLight{
    {{0.1840, 0.0179, 0.0048}, {0.0876, 0.0118, 0.0018}, {0.0005, 0.0012, 0.0159}}};
inline constexpr LightMatrix kCyanLensLight{
    {{0.0153, 0.1092, 0.1171}, {0.0176, 0.3088, 0.0777}, {0.0201, 0.1016, 0.6546}}};

// Red-cyan glasses have the measured lenses. There are no published matrices for other glasses, so
// their lenses are ideal: they let through the screen's light of the eye's own channels and nothing
// of the other channels, so nothing leaks.
Lenses lenses_of(Glasses glasses);

// The luminance Y of the shown colour, in linear light, through a lens.
inline double luminance(const LightMatrix& lens, const Linear& shown) {
  const auto& y = lens[1];
  return y[0] * double(shown[0]) + y[1] * double(shown[1]) + y[2] * double(shown[2]);
}

}  // namespace glassbox
