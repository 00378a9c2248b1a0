// Predicts the errors of sample footprints for colours that are independent of each other (D-15):
// each footprint is a filter that is described by its weights.
//
// If the colours c of the samples are independent with mean m and variance s, a sum of d c with the
// weights d has the mean square s sum(d^2) + m^2 (sum d)^2. Errors and differences between
// neighbours are such sums.
#pragma once

#include <map>
#include <utility>

#include "study/experiments/d15_splats.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study::d15 {

// The weights of samples (i, j) in a pixel; i counts to the right, j downwards.
using Weights = std::map<std::pair<int, int>, double>;

inline Weights minus(Weights a, const Weights& b) {
  for (const auto& [sample, weight] : b) a[sample] -= weight;
  return a;
}

inline double mean_square(const Weights& differences) {
  constexpr double kMean = 127.5, kVariance = (256.0 * 256 - 1) / 12;  // of a random byte
  double squares = 0, sum = 0;
  for (const auto& [sample, d] : differences) squares += d * d, sum += d;
  return kVariance * squares + kMean * kMean * sum * sum;
}

// The place in the other picture to which sample (i, j) is warped.
inline std::pair<double, double> place_of(int i, int j, const Magnification& m) {
  return {(i + 0.5) * m.x, (j + 0.5) * m.y};
}
// Visits the samples that may reach a pixel, bottom row first, in the order of drawing.
template <class Visit>
void visit_near(int u, int v, const Magnification& m, Visit&& visit) {
  constexpr int kReach = 8;
  const int i = int(std::floor(u / m.x)), j = int(std::floor(v / m.y));
  for (int b = j + kReach; b >= j - kReach; --b) {
    for (int a = i - kReach; a <= i + kReach; ++a) visit(a, b);
  }
}

// Finds the first sample whose square (x - side/2, x + side/2] contains the pixel's centre, and
// gives it the weight 1.
inline Weights weights_in(int u, int v, const Magnification& m, const Square& square) {
  Weights found;
  visit_near(u, v, m, [&](int i, int j) {
    const auto [x, y] = place_of(i, j, m);
    const double dx = u + 0.5 - x, dy = v + 0.5 - y, half = square.side / 2;
    if (found.empty() && dx > -half && dx <= half && dy > -half && dy <= half) found[{i, j}] = 1;
  });
  return found;
}
inline Weights weights_in(int u, int v, const Magnification& m, const Ellipse& ellipse) {
  Weights found;
  visit_near(u, v, m, [&](int i, int j) {
    const auto [x, y] = place_of(i, j, m);
    const double a = (u + 0.5 - x) / ellipse.half_width, b = (v + 0.5 - y) / ellipse.half_height;
    const bool is_cut = a == -1 || b == -1;  // the box around the ellipse is half open
    if (found.empty() && a * a + b * b <= 1 && !is_cut) found[{i, j}] = 1;
  });
  return found;
}
inline Weights normalised(Weights weights) {
  double sum = 0;
  for (const auto& [sample, w] : weights) sum += w;
  for (auto& [sample, w] : weights) w /= sum;
  return weights;
}
inline Weights weights_in(int u, int v, const Magnification& m, const FourSizes& sizes) {
  Weights found;
  visit_near(u, v, m, [&](int i, int j) {
    const auto [x, y] = place_of(i, j, m);
    const int a = u - int(std::floor(x)), b = v - int(std::floor(y));
    if (std::max(std::abs(a), std::abs(b)) <= sizes.side / 2) found[{i, j}] = sizes.weight(a, b);
  });
  return normalised(std::move(found));
}
inline Weights weights_in(int u, int v, const Magnification& m, const Gaussian& bell) {
  Weights found;
  visit_near(u, v, m, [&](int i, int j) {
    const auto [x, y] = place_of(i, j, m);
    const double dx = u + 0.5 - x, dy = v + 0.5 - y;
    const bool is_near = std::abs(dx) <= Gaussian::kReach * bell.deviation_x &&
                         std::abs(dy) <= Gaussian::kReach * bell.deviation_y;
    if (is_near) found[{i, j}] = bell.weight(dx, dy);
  });
  return normalised(std::move(found));
}

// The exact weights: how much of the pixel is covered by the warped pixel of each sample.
inline Weights truth_in(int u, int v, const Magnification& m) {
  Weights found;
  visit_near(u, v, m, [&](int i, int j) {
    const auto overlap = [](double a, double size, int pixel) {
      return std::max(0.0, std::min(a + size, pixel + 1.0) - std::max(a, double(pixel)));
    };
    const double area = overlap(i * m.x, m.x, u) * overlap(j * m.y, m.y, v);
    if (area > 0) found[{i, j}] = area;
  });
  return found;
}

struct Expected {
  double holes = 0;          // as a fraction of the pixels
  double mean_square = 0;    // of the error of a channel, (1/255)^2
  double gradient = 0;       // mean square of the difference to the pixel on the right
  double true_gradient = 0;  // the same for the true picture
};

// Averages over all positions of a pixel relative to the samples. With the magnifications of this
// experiment, these positions repeat after `period` pixels at the latest.
template <class Footprint>
Expected expect(const Magnification& m, const Footprint& footprint) {
  const int period = 8;
  Expected mean;
  for (int v = 0; v < period; ++v) {
    for (int u = 0; u < period; ++u) {
      const double share = 1.0 / (period * period);
      const Weights here = weights_in(u, v, m, footprint), there = truth_in(u, v, m);
      const Weights next = weights_in(u + 1, v, m, footprint), beyond = truth_in(u + 1, v, m);
      mean.holes += here.empty() ? share : 0;
      mean.mean_square += share * d15::mean_square(minus(here, there));
      // The mean of several bytes is rounded to a byte.
      if (here.size() > 1) mean.mean_square += share / 12;
      mean.gradient += share * d15::mean_square(minus(next, here));
      mean.true_gradient += share * d15::mean_square(minus(beyond, there));
    }
  }
  return mean;
}

}  // namespace glassbox::study::d15
