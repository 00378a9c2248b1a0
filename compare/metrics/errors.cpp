#include <glassbox/compare/metrics/errors.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glassbox/base/elementary.h>
#include <glassbox/compare/metrics/samples.h>

namespace glassbox {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The errors of one row of pixels. `squares` is the sum of the squared differences, in steps of the
// format, or of the floats themselves.
struct RowErrors {
  double largest = 0;
  double squares = 0;
  double peak = 0;
};

template <class Sample>
double distance(Sample reference, Sample test, bool) {
  return std::abs(double(reference) - double(test));
}

double distance(float reference, float test, bool nan_equals_nan) {
  if (std::isnan(reference) || std::isnan(test)) {
    return nan_equals_nan && std::isnan(reference) && std::isnan(test) ? 0 : kInfinity;
  }
  if (reference == test) return 0;  // also for equal infinities, whose difference would be NaN
  return std::abs(double(reference) - double(test));
}

template <class Sample>
RowErrors row_errors(const PicturePair& pair, const Sample* reference, const Sample* test, int y) {
  RowErrors row;
  for (int x = 0; x < pair.reference.width; ++x) {
    for (int channel = 0; channel < pair.reference.channels; ++channel, ++reference, ++test) {
      if (!pair.selection.compares(x, y)) continue;
      const double error = distance(*reference, *test, pair.nan_equals_nan);
      row.largest = std::max(row.largest, error);
      row.squares += error * error;
      const double magnitude = std::abs(double(*reference));
      if (std::isfinite(magnitude)) row.peak = std::max(row.peak, magnitude);
    }
  }
  return row;
}

std::vector<RowErrors> all_rows(const PicturePair& pair) {
  std::vector<RowErrors> rows(std::size_t(pair.reference.height));
  const auto row_samples = std::size_t(pair.reference.width) * std::size_t(pair.reference.channels);
  std::visit(
      [&](const auto& reference) {
        const auto& test = std::get<std::decay_t<decltype(reference)>>(pair.test.samples);
        tbb::parallel_for(std::size_t(0), rows.size(), [&](std::size_t y) {
          rows[y] = row_errors(pair, reference.data() + y * row_samples,
                               test.data() + y * row_samples, int(y));
        });
      },
      pair.reference.samples);
  return rows;
}

}  // namespace

SampleErrors sample_errors(const PicturePair& pair) {
  RowErrors sum;
  for (const RowErrors& row : all_rows(pair)) {
    sum.largest = std::max(sum.largest, row.largest);
    sum.squares += row.squares;
    sum.peak = std::max(sum.peak, row.peak);
  }
  SampleErrors errors;
  errors.samples = pair.selection.compared_pixels() * std::uint64_t(pair.reference.channels);
  if (errors.samples == 0) return errors;
  const double scale = full_scale(pair.reference);
  errors.absmax = sum.largest / scale;
  errors.rmse = std::sqrt(sum.squares / double(errors.samples)) / scale;
  errors.peak = has_floats(pair.reference) ? sum.peak : 1;
  return errors;
}

double psnr(const SampleErrors& errors) {
  if (errors.rmse == 0) return kInfinity;
  return 20 * logarithm_10(errors.peak / errors.rmse);
}

}  // namespace glassbox
