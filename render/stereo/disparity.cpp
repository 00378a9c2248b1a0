#include <glassbox/render/stereo/disparity.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/pipeline/stereo/parallax.h>

namespace glassbox {
namespace {

constexpr double kFinestBin = 1e-3;  // px; finer bins would show the rounding of distances to float

std::int64_t bin_of(double px, double bin_px) {
  return std::int64_t(std::floor(px / bin_px));
}

// Returns a bin width from the series 0.001, 0.002, 0.005, 0.01 ...
double bin_width(double least, double greatest, int most_bins) {
  // At most a million bins on each side of the window, because floats can hardly distinguish finer
  // disparities, and the numbers of bins are integers.
  const double finest = std::max({kFinestBin, std::abs(least) * 1e-6, std::abs(greatest) * 1e-6});
  for (double decade = kFinestBin;; decade *= 10) {
    for (const double width : {decade, 2 * decade, 5 * decade}) {
      if (width < finest) continue;
      if (bin_of(greatest, width) - bin_of(least, width) < most_bins) return width;
    }
  }
}

}  // namespace

Image<float> disparity_map(const View& centre, const StereoPair& pair,
                           const Image<float>& distances) {
  Image<float> disparity(distances.width, distances.height,
                         std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < distances.pixels.size(); ++i) {
    const double distance = double(distances.pixels[i]);
    if (!std::isfinite(distance)) continue;
    disparity.pixels[i] = float(parallax_at(centre, pair, distance).px);
  }
  return disparity;
}

DisparitySummary summarise_disparity(const Image<float>& disparity, const ParallaxBudget& budget) {
  // The budget is rounded to float as the disparities are, so that a disparity within the budget
  // stays within it.
  const float in_front = float(budget.in_front_px), behind = float(budget.behind_px);
  DisparitySummary found;
  for (const float pixel : disparity.pixels) {
    const double px = double(pixel);
    if (!std::isfinite(px)) continue;
    found.least_px = found.drawn == 0 ? px : std::min(found.least_px, px);
    found.greatest_px = found.drawn == 0 ? px : std::max(found.greatest_px, px);
    ++found.drawn;
    found.too_near += -pixel > in_front;
    found.too_far += pixel > behind;
  }
  return found;
}

DisparityHistogram histogram_of(const Image<float>& disparity, int most_bins) {
  const DisparitySummary ends = summarise_disparity(disparity, {});
  if (ends.drawn == 0) return {};
  DisparityHistogram histogram;
  histogram.bin_px = bin_width(ends.least_px, ends.greatest_px, most_bins);
  const std::int64_t first = bin_of(ends.least_px, histogram.bin_px);
  const std::int64_t last = bin_of(ends.greatest_px, histogram.bin_px);
  histogram.first_px = double(first) * histogram.bin_px;
  histogram.counts.assign(std::size_t(last - first + 1), 0);
  for (const float pixel : disparity.pixels) {
    if (!std::isfinite(pixel)) continue;
    ++histogram.counts[std::size_t(bin_of(double(pixel), histogram.bin_px) - first)];
  }
  return histogram;
}

}  // namespace glassbox
