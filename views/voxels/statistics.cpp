#include "views/voxels/statistics.h"

#include <cmath>

namespace glassbox::views {

namespace {

__extension__ using Wide = __int128;

// The regularised incomplete gamma functions, by the series for P and Lentz's continued fraction for Q: each where it converges
// quickly (Press et al., Numerical Recipes, 6.2). Q(a, x) is returned.
double gamma_tail(double a, double x) {
  if (!(x > 0)) return 1;
  const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
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
  // Digits that a C library may have otherwise are left out.
  const double scale = std::pow(10, 9 - std::ceil(std::log10(high)));
  return std::round(high * scale) / scale;
}

}  // namespace glassbox::views
