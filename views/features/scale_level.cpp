#include "views/features/scale_level.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <tbb/parallel_for.h>

#include "views/features/gaussian.h"

namespace glassbox::views {

namespace {

constexpr double kCameraSigma = 0.5;  // px: the smoothing of a picture from a camera

// The standard deviation of the Gaussian that makes one of `after` from one of `before`: variances
// of successive convolutions add up.
double missing_sigma(double before, double after) {
  return std::sqrt(after * after - before * before);
}

Image<float> grey_of(const Image<Rgba8>& picture) {
  Image<float> grey(picture.width, picture.height);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const Rgba8& pixel = picture.pixels[i];
    grey.pixels[i] = float(77 * pixel.r + 150 * pixel.g + 29 * pixel.b) / 256;
  }
  return grey;
}

// Adds weight times row `from` to the sums.
void add_row(const float* from, double weight, std::vector<double>& sums) {
  for (std::size_t x = 0; x < sums.size(); ++x) sums[x] += weight * double(from[x]);
}

}  // namespace

Image<float> smoothed(const Image<float>& grey, double sigma) {
  const int radius = int(std::ceil(3 * sigma));
  const std::vector<double> weights = gaussian_weights(sigma, radius);
  const auto width = std::size_t(grey.width), reach = std::size_t(radius);
  Image<float> result(grey.width, grey.height);
  tbb::parallel_for(0, grey.height, [&](int y) {
    std::vector<double> down(width, 0);
    for (int dy = -radius; dy <= radius; ++dy) {
      const int row = std::clamp(y + dy, 0, grey.height - 1);
      add_row(&grey.at(0, row), weights[std::size_t(dy + radius)], down);
    }
    std::vector<float> padded(width + 2 * reach);
    for (std::size_t i = 0; i < padded.size(); ++i) {
      padded[i] = float(down[std::min(std::max(i, reach) - reach, width - 1)]);
    }
    std::vector<double> sums(width, 0);
    for (std::size_t i = 0; i < weights.size(); ++i) add_row(padded.data() + i, weights[i], sums);
    for (std::size_t x = 0; x < width; ++x) result.at(int(x), y) = float(sums[x]);
  });
  return result;
}

double grey_at(const Image<float>& grey, double x, double y) {
  const double across = std::clamp(x - 0.5, 0.0, double(grey.width - 1));
  const double down = std::clamp(y - 0.5, 0.0, double(grey.height - 1));
  const int left = int(across), top = int(down);
  const int right = std::min(left + 1, grey.width - 1), bottom = std::min(top + 1, grey.height - 1);
  const double u = across - left, v = down - top;
  const double above = (1 - u) * double(grey.at(left, top)) + u * double(grey.at(right, top));
  const double below = (1 - u) * double(grey.at(left, bottom)) + u * double(grey.at(right, bottom));
  return (1 - v) * above + v * below;
}

ScaleLevel finest_level(const Image<Rgba8>& picture) {
  return {smoothed(grey_of(picture), missing_sigma(kCameraSigma, kLevelSigma)), 1};
}

ScaleLevel coarser_level(const ScaleLevel& finer) {
  const Image<float> source =
      smoothed(finer.grey, missing_sigma(kLevelSigma, kLevelSigma * kScaleStep));
  ScaleLevel level{
      {std::max(1, int(source.width / kScaleStep)), std::max(1, int(source.height / kScaleStep))},
      finer.scale * kScaleStep};
  tbb::parallel_for(0, level.grey.height, [&](int y) {
    for (int x = 0; x < level.grey.width; ++x) {
      level.grey.at(x, y) = float(grey_at(source, (x + 0.5) * kScaleStep, (y + 0.5) * kScaleStep));
    }
  });
  return level;
}

}  // namespace glassbox::views
