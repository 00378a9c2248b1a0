#include "views/features/corner_response.h"

#include <cmath>
#include <vector>

#include <tbb/parallel_for.h>

#include "views/features/gaussian.h"

namespace glassbox::views {

namespace {

// The sums of the matrix M for the pixels of a row.
struct RowSums {
  explicit RowSums(int width)
      : a(std::size_t(width), 0), b(std::size_t(width), 0), c(std::size_t(width), 0) {}
  std::vector<double> a, b, c;
};

void add_products(const Image<float>& grey, int y, double weight, RowSums& sums) {
  const float *above = &grey.at(0, y - 1), *here = &grey.at(0, y), *below = &grey.at(0, y + 1);
  for (std::size_t x = 1; x + 1 < std::size_t(grey.width); ++x) {
    const double gx = (double(here[x + 1]) - double(here[x - 1])) / 2;
    const double gy = (double(below[x]) - double(above[x])) / 2;
    sums.a[x] += weight * gx * gx;
    sums.b[x] += weight * gx * gy;
    sums.c[x] += weight * gy * gy;
  }
}

double weighted(const std::vector<double>& values, std::size_t from,
                const std::vector<double>& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * values[from + i];
  return sum;
}

}  // namespace

const char* name_of(Detector detector) {
  return detector == Detector::kHarris ? "harris" : "shi-tomasi";
}

double corner_response(Detector detector, double a, double b, double c) {
  if (detector == Detector::kHarris) {
    return (a * c - b * b) - kHarrisTrace * ((a + c) * (a + c));
  }
  const double half = (a - c) / 2;
  return (a + c) / 2 - std::sqrt(half * half + b * b);
}

Image<float> response_map(const Image<float>& grey, Detector detector) {
  constexpr int kMargin = kWindowRadius + 1;
  const std::vector<double> weights = gaussian_weights(kWindowSigma, kWindowRadius);
  Image<float> map(grey.width, grey.height, 0.0f);
  tbb::parallel_for(kMargin, std::max(kMargin, grey.height - kMargin), [&](int y) {
    RowSums down(grey.width);
    for (int dy = -kWindowRadius; dy <= kWindowRadius; ++dy) {
      add_products(grey, y + dy, weights[std::size_t(dy + kWindowRadius)], down);
    }
    for (int x = kMargin; x < grey.width - kMargin; ++x) {
      const auto from = std::size_t(x - kWindowRadius);
      map.at(x, y) =
          float(corner_response(detector, weighted(down.a, from, weights),
                                weighted(down.b, from, weights), weighted(down.c, from, weights)));
    }
  });
  return map;
}

}  // namespace glassbox::views
