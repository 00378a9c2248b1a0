// The colour spaces of FLIP and its measure of the difference of two colours, pixel by pixel.
#pragma once

#include <algorithm>
#include <cmath>

#include <glassbox/images/colour/power.h>

namespace glassbox::flip_colour {

struct Matrix {
  double at[3][3];
};

// Converts linear sRGB to CIE XYZ, with the primaries of ITU-R BT.709 and white at x = 0.31271, y =
// 0.32902. The numbers are exact fractions.
inline constexpr Matrix kXyzFromRgb{
    {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

// Converts linear sRGB to XYZ divided by the XYZ of white, so each row adds up to 1.
inline constexpr Matrix kRelativeFromRgb = [] {
  Matrix relative = kXyzFromRgb;
  for (auto& row : relative.at) {
    const double white = row[0] + row[1] + row[2];
    for (double& value : row) value /= white;
  }
  return relative;
}();

inline constexpr Matrix kRgbFromRelative = [] {
  const auto& m = kRelativeFromRgb.at;
  Matrix inverse{};
  double determinant = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      inverse.at[j][i] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
      if (i == 0) determinant += m[0][j] * inverse.at[j][0];
    }
  }
  for (auto& row : inverse.at) {
    for (double& value : row) value /= determinant;
  }
  return inverse;
}();

struct Colour {
  float x, y, z;
};

inline Colour times(const Matrix& matrix, Colour colour) {
  const auto row = [&](int i) {
    return float(matrix.at[i][0]) * colour.x + float(matrix.at[i][1]) * colour.y +
           float(matrix.at[i][2]) * colour.z;
  };
  return {row(0), row(1), row(2)};
}

// The colour space YCxCz without its scales and its offset, which filters do not change: the three
// numbers are Y/Yn, X/Xn - Y/Yn and Y/Yn - Z/Zn, where (Xn, Yn, Zn) is white. The paper's Y is 116
// times the first number minus 16, its Cx is 500 times the second and its Cz 200 times the third.
inline Colour opponent_of_linear(Colour rgb) {
  const Colour relative = times(kRelativeFromRgb, rgb);
  return {relative.y, relative.x - relative.y, relative.y - relative.z};
}

// The linear sRGB colour, clamped to the colours that a monitor can show.
inline Colour linear_of_opponent(Colour opponent) {
  const Colour rgb =
      times(kRgbFromRelative, {opponent.x + opponent.y, opponent.x, opponent.x - opponent.z});
  const auto clamp = [](float value) { return std::min(std::max(value, 0.0f), 1.0f); };
  return {clamp(rgb.x), clamp(rgb.y), clamp(rgb.z)};
}

// The cube root of CIELab, which is replaced by a straight line near black.
inline float lab_root(float value) {
  constexpr float kDelta = 6.0f / 29.0f;
  constexpr float kCube = kDelta * kDelta * kDelta;
  const float root = cube_root(std::max(value, kCube));
  const float line = value * (1.0f / (3.0f * kDelta * kDelta)) + 4.0f / 29.0f;
  return value > kCube ? root : line;
}

// CIELab with Hunt's adjustment, which makes differences of colour smaller where it is dark.
inline Colour hunt_lab_of_linear(Colour rgb) {
  const Colour relative = times(kRelativeFromRgb, rgb);
  const float x = lab_root(relative.x);
  const float y = lab_root(relative.y);
  const float z = lab_root(relative.z);
  const float lightness = 116.0f * y - 16.0f;
  return {lightness, 0.01f * lightness * (500.0f * (x - y)),
          0.01f * lightness * (200.0f * (y - z))};
}

// The HyAB distance: the difference in lightness plus the Euclidean distance in the other two
// coordinates.
inline float hyab(Colour a, Colour b) {
  const float dy = a.y - b.y;
  const float dz = a.z - b.z;
  return std::abs(a.x - b.x) + std::sqrt(dy * dy + dz * dz);
}

// The error of two colours at a HyAB distance, in [0, 1]. The distance is raised to a power and
// then mapped by two straight lines: values from 0 to the fraction `turn` of the largest value
// (that of green and blue) to 0 .. `target`, and larger values to `target` .. 1.
class ColourError {
public:
  ColourError()
      : largest_(
            power(hyab(hunt_lab_of_linear({0, 1, 0}), hunt_lab_of_linear({0, 0, 1})), kPower)) {}

  float operator()(float distance) const {
    const float raised = power(distance, kPower);
    const float turn = kTurn * largest_;
    const float low = raised * (kTarget / turn);
    const float high = kTarget + (raised - turn) * ((1.0f - kTarget) / (largest_ - turn));
    return std::min(raised < turn ? low : high, 1.0f);
  }

private:
  static constexpr float kPower = 0.7f;    // q_c in the paper
  static constexpr float kTurn = 0.4f;     // p_c in the paper
  static constexpr float kTarget = 0.95f;  // p_t in the paper
  float largest_;                          // c_max in the paper
};

// The error of edges and points (features) whose strengths differ by `difference`, in [0, 1]; the
// paper's exponent q_f is 1/2.
inline float feature_error(float difference) {
  return std::min(std::sqrt(difference * 0.70710678118654752f), 1.0f);
}

// Combines the errors of colour and features: a difference of features makes the colour error
// larger.
inline float combined_error(float colour, float feature) {
  return std::min(power(colour, 1.0f - feature), 1.0f);
}

}  // namespace glassbox::flip_colour
