#include "views/voxels/statistics.h"

#include <algorithm>
#include <cmath>

#include <glassbox/base/elementary.h>

namespace glassbox::views {

namespace {

__extension__ using Wide = __int128;

// ln Gamma(a), a > 0: Stirling's series for a >= 10; smaller arguments are increased by the
// recurrence Gamma(a + 1) = a Gamma(a). The first term that is left out is 1 / (156 a^13), less
// than 1e-15 there.
double log_gamma(double a) {
  double product = 1;
  for (; a < 10; a += 1) product *= a;
  const double z = 1 / (a * a);
  const double series =
      (1.0 / 12 - z * (1.0 / 360 -
                       z * (1.0 / 1260 - z * (1.0 / 1680 - z * (1.0 / 1188 - z * 691 / 360360))))) /
      a;
  constexpr double kHalfLogOfTwoPi = 0.91893853320467274178;
  return (a - 0.5) * logarithm(a) - a + kHalfLogOfTwoPi + series - logarithm(product);
}

// The regularised incomplete gamma function Q(a, x), from the series for P = 1 - Q or from Lentz's
// continued fraction for Q, whichever converges quickly (Press et al., Numerical Recipes, 6.2).
double gamma_tail(double a, double x) {
  if (!(x > 0)) return 1;
  const double front = exponential(a * logarithm(x) - x - log_gamma(a));
  constexpr int kTerms = 100000;
  constexpr double kSmall = 1e-15;
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (int n = 1; n < kTerms && term > sum * kSmall; ++n) {
      term *= x / (a + n);
      sum += term;
    }
    return 1 - front * sum;
  }
  constexpr double kTiny = 1e-300;
  double b = x + 1 - a, c = 1 / kTiny, d = 1 / b, product = d;
  for (int n = 1; n < kTerms; ++n) {
    const double numerator = -n * (n - a);
    b += 2;
    d = numerator * d + b;
    if (std::abs(d) < kTiny) d = kTiny;
    c = b + numerator / c;
    if (std::abs(c) < kTiny) c = kTiny;
    d = 1 / d;
    product *= d * c;
    if (std::abs(d * c - 1) < kSmall) break;
  }
  return front * product;
}

}  // namespace

double ColorSums::deviations() const {
  if (count == 0) return 0;
  Wide of_means = 0;
  for (const std::int64_t sum : channel) of_means += Wide(sum) * sum;
  return double(Wide(count) * squares - of_means) / double(count);
}

double chi_squared_tail(double degrees, double x) {
  return gamma_tail(degrees / 2, x / 2);
}

double chi_squared_quantile(double degrees, double tail) {
  double low = 0, high = degrees + 10;
  while (chi_squared_tail(degrees, high) > tail) high *= 2;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (chi_squared_tail(degrees, middle) > tail ? low : high) = middle;
  }
  // Rounds to nine digits, the accuracy of the series.
  const double scale = whole_power(10, std::max(0, 9 - int(std::ceil(logarithm_10(high)))));
  return std::round(high * scale) / scale;
}

}  // namespace glassbox::views
