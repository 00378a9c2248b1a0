// Computes how a shown colour looks through red and cyan glasses, and the methods that choose the
// shown colours (D-12).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <glassbox/images/colour/ciede2000.h>
#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/images/stereo/lenses.h>
#include <glassbox/images/stereo/recolour.h>

namespace glassbox::study::d12 {

// ---- what is seen through the glasses ----

using Colour3 = std::array<double, 3>;

inline Colour3 times(const LightMatrix& m, const Colour3& v) {
  Colour3 product{};
  for (std::size_t i = 0; i < 3; ++i) product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return product;
}

inline LightMatrix inverse(const LightMatrix& m) {
  LightMatrix adjugate;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t r = (k + 1) % 3, s = (k + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      adjugate[i][k] = m[r][c] * m[s][d] - m[r][d] * m[s][c];
    }
  }
  const double determinant =
      m[0][0] * adjugate[0][0] + m[0][1] * adjugate[1][0] + m[0][2] * adjugate[2][0];
  for (auto& row : adjugate) {
    for (double& entry : row) entry /= determinant;
  }
  return adjugate;
}

// The colour that an eye behind a lens sees, as a screen would have to show it without glasses. The
// eye adapts to the lens: X, Y and Z are each relative to the value for white through the lens (von
// Kries).
class ColourThroughLens {
public:
  explicit ColourThroughLens(const LightMatrix& lens)
      : lens_(lens),
        screen_from_light_(inverse(kScreenLight)),
        white_(times(lens, {1, 1, 1})),
        screen_white_(times(kScreenLight, {1, 1, 1})) {}

  Lab operator()(const Colour3& shown) const {
    Colour3 light = times(lens_, shown);
    for (std::size_t i = 0; i < 3; ++i) light[i] *= screen_white_[i] / white_[i];
    Colour3 colour = times(screen_from_light_, light);
    for (double& channel : colour) channel = std::clamp(channel, 0.0, 1.0);
    return lab_of_linear(colour[0], colour[1], colour[2]);
  }

private:
  LightMatrix lens_, screen_from_light_;
  Colour3 white_, screen_white_;
};

// The light of both lenses together, which is the colour that the two eyes combine.
inline LightMatrix both_lenses() {
  LightMatrix sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) sum[i][k] = kRedLensLight[i][k] + kCyanLensLight[i][k];
  }
  return sum;
}

// ---- methods ----

// An anaglyph method: returns the linear light that the screen shows if both eyes should see the
// given colour.
using ShownColour = std::function<Colour3(const Linear&)>;

inline Colour3 in_double(const Linear& c) {
  return {double(c[0]), double(c[1]), double(c[2])};
}

inline ShownColour by_matrix(const AnaglyphMatrix& matrix, const Recolour& recolour) {
  return [=](const Linear& colour) {
    const Linear c = recoloured(colour, recolour);
    return in_double(mix_eyes(matrix, c, c));
  };
}

inline double square(double x) {
  return x * x;
}

inline double distance2(const Lab& a, const Lab& b) {
  return square(a.l - b.l) + square(a.a - b.a) + square(a.b - b.b);
}

// The shown colour that is nearest to the wanted one in CIELAB, for each eye through its own lens
// (McAllister, Zhou and Sullivan 2010): minimizes the sum of both squared distances by a search
// with halving steps, starting at the wanted colour itself.
class LabOptimum {
public:
  Colour3 operator()(const Linear& colour) const {
    const Colour3 wanted = in_double(colour);
    const Lab goal = lab_of_linear(wanted[0], wanted[1], wanted[2]);
    const auto cost = [&](const Colour3& shown) {
      return distance2(left_(shown), goal) + distance2(right_(shown), goal);
    };
    Colour3 best = wanted;
    double least = cost(best);
    for (double step = 0.25; step > 1.0 / 512;) {
      bool moved = false;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        for (const double by : {-step, step}) {
          Colour3 next = best;
          next[channel] = std::clamp(next[channel] + by, 0.0, 1.0);
          const double at_next = cost(next);
          if (at_next < least) best = next, least = at_next, moved = true;
        }
      }
      if (!moved) step /= 2;
    }
    return best;
  }

private:
  ColourThroughLens left_{kRedLensLight}, right_{kCyanLensLight};
};

}  // namespace glassbox::study::d12
