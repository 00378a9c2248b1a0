#include <glassbox/compare/metrics/flip_filters.h>

#include <cmath>

#include <glassbox/base/elementary.h>

namespace glassbox {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double square(double value) {
  return value * value;
}

// The contrast sensitivity of each opponent colour is a sum of Gaussians with the amplitude a and
// the width b (square degrees), from table 1 of the paper.
constexpr double kLightnessWidth = 0.0047;
constexpr double kRedGreenWidth = 0.0053;
constexpr double kWideAmplitude = 34.1, kWideWidth = 0.04;
constexpr double kNarrowAmplitude = 13.5, kNarrowWidth = 0.025;

// px; the paper's w is 0.082 degrees
constexpr double kFeatureDeviation = 0.5 * 0.082 * kPixelsPerDegree;

// The radii are three standard deviations, rounded up. A Gaussian of the width b has the variance
// b / (2 pi^2) in square degrees.
constexpr double kColourVariance = kWideWidth / (2 * square(kPi)) * square(kPixelsPerDegree);
static_assert(square(kColourRadius - 1) < 9 * kColourVariance);
static_assert(9 * kColourVariance <= square(kColourRadius));
static_assert(kFeatureRadius - 1 < 3 * kFeatureDeviation &&
              3 * kFeatureDeviation <= kFeatureRadius);

double contrast_gaussian(double width, int r) {
  return exponential(-square(kPi * r / kPixelsPerDegree) / width);
}

// The sum of a Gaussian's values along one axis, up to the radius that the paper uses.
double contrast_sum(double width) {
  double sum = 1;
  for (int r = kColourRadius; r > 0; --r) sum += 2 * contrast_gaussian(width, r);
  return sum;
}

template <std::size_t radius>
void set_contrast(double width, Taps<float, radius>& taps) {
  for (std::size_t r = 1; r <= radius; ++r) {
    taps[r - 1] = float(contrast_gaussian(width, int(r)) / contrast_sum(width));
  }
}

void set_blue_yellow(FlipFilters& filters) {
  set_contrast(kWideWidth, filters.wide_blue_yellow);
  set_contrast(kNarrowWidth, filters.narrow_blue_yellow);
  const double wide =
      kWideAmplitude * std::sqrt(kPi / kWideWidth) * square(contrast_sum(kWideWidth));
  const double narrow =
      kNarrowAmplitude * std::sqrt(kPi / kNarrowWidth) * square(contrast_sum(kNarrowWidth));
  filters.wide_share = float(wide / (wide + narrow));
  filters.narrow_share = float(narrow / (wide + narrow));
}

double feature_gaussian(int r) {
  return exponential(-square(r / kFeatureDeviation) / 2);
}
double feature_slope(int r) {
  return r * feature_gaussian(r);
}
double feature_bend(int r) {
  return (square(r / kFeatureDeviation) - 1) * feature_gaussian(r);
}

void set_features(FlipFilters& filters) {
  double smooth = feature_gaussian(0);
  double slope = 0;
  double rise = 0;
  double fall = -feature_bend(0);  // the centre is the only weight that occurs once
  for (int r = 1; r <= kFeatureRadius; ++r) {
    smooth += 2 * feature_gaussian(r);
    slope += feature_slope(r);
    (feature_bend(r) > 0 ? rise : fall) += 2 * std::abs(feature_bend(r));
  }
  for (int r = 1; r <= kFeatureRadius; ++r) {
    const auto tap = std::size_t(r - 1);
    const double bend = feature_bend(r);
    filters.smooth[tap] = float(feature_gaussian(r) / smooth);
    filters.slope[tap] = float(feature_slope(r) / slope);
    filters.bend[tap] = float(bend / (bend > 0 ? rise : fall));
  }
}

FlipFilters make_filters() {
  FlipFilters filters;
  set_contrast(kLightnessWidth, filters.lightness);
  set_contrast(kRedGreenWidth, filters.red_green);
  set_blue_yellow(filters);
  set_features(filters);
  return filters;
}

}  // namespace

const FlipFilters& flip_filters() {
  static const FlipFilters filters = make_filters();
  return filters;
}

}  // namespace glassbox
