#include <glassbox/images/colour/ciede2000.h>

#include <cmath>

#include <glassbox/base/elementary.h>
#include <glassbox/base/trig.h>
#include <glassbox/images/colour/flip_colour.h>

namespace glassbox {
namespace {

double power_7(double x) {
  const double cube = x * x * x;
  return cube * cube * x;
}

// How saturated a colour of this chroma is: 0 for greys, near 1 for chroma far above 25.
double saturation(double chroma) {
  constexpr double k25 = 6103515625.0;  // 25^7
  const double high = power_7(chroma);
  return std::sqrt(high / (high + k25));
}

// The hue in [0, 360); 0 for greys, where the hue has no effect.
double hue_degrees(double a, double b) {
  const double degrees = degrees_from_radians(arctan2(b, a));
  return degrees < 0 ? degrees + 360 : degrees;
}

double cosine(double degrees) {
  return sin_cos_degrees(degrees).cos;
}

double square(double x) {
  return x * x;
}

}  // namespace

Lab lab_of_linear(double red, double green, double blue) {
  const auto root_of = [&](const double* row) {
    constexpr double kDelta = 6.0 / 29;
    const double relative = row[0] * red + row[1] * green + row[2] * blue;
    return relative > kDelta * kDelta * kDelta ? cube_root(relative)
                                               : relative / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const auto& rows = flip_colour::kRelativeFromRgb.at;
  const double x = root_of(rows[0]), y = root_of(rows[1]), z = root_of(rows[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Names and order follow the paper: C stands for chroma, h for hue, a prime for values from the
// adjusted a.
double ciede2000(const Lab& one, const Lab& other) {
  const double mean_c = (std::sqrt(one.a * one.a + one.b * one.b) +
                         std::sqrt(other.a * other.a + other.b * other.b)) /
                        2;
  const double widen = 1 + 0.5 * (1 - saturation(mean_c));
  const double a1 = widen * one.a, a2 = widen * other.a;
  const double c1 = std::sqrt(a1 * a1 + one.b * one.b);
  const double c2 = std::sqrt(a2 * a2 + other.b * other.b);
  const double h1 = hue_degrees(a1, one.b), h2 = hue_degrees(a2, other.b);
  const bool has_grey = c1 * c2 == 0;

  // The hue difference is taken the shorter way round the circle; it is 0 if one colour is grey.
  double turn = has_grey ? 0 : h2 - h1;
  if (turn > 180) turn -= 360;
  if (turn < -180) turn += 360;
  double mean_h = h1 + h2;
  if (!has_grey) {
    if (std::abs(h1 - h2) > 180) mean_h += mean_h < 360 ? 360 : -360;
    mean_h /= 2;
  }

  const double dl = other.l - one.l;
  const double dc = c2 - c1;
  const double dh = 2 * std::sqrt(c1 * c2) * sin_cos_degrees(turn / 2).sin;

  const double mean_l = (one.l + other.l) / 2;
  const double mean_c_prime = (c1 + c2) / 2;
  const double t = 1 - 0.17 * cosine(mean_h - 30) + 0.24 * cosine(2 * mean_h) +
                   0.32 * cosine(3 * mean_h + 6) - 0.20 * cosine(4 * mean_h - 63);
  const double l_50 = square(mean_l - 50);
  const double sl = 1 + 0.015 * l_50 / std::sqrt(20 + l_50);
  const double sc = 1 + 0.045 * mean_c_prime;
  const double sh = 1 + 0.015 * mean_c_prime * t;
  const double rotation = 30 * exponential(-square((mean_h - 275) / 25));
  const double rt = -sin_cos_degrees(2 * rotation).sin * 2 * saturation(mean_c_prime);

  const double l = dl / sl, c = dc / sc, h = dh / sh;
  return std::sqrt(l * l + c * c + h * h + rt * c * h);
}

}  // namespace glassbox
