// The weights of a Gaussian window.
#pragma once

#include <vector>

#include <glassbox/base/elementary.h>

namespace glassbox::views {

// Weights for the offsets -radius .. radius of a Gaussian with standard deviation `sigma`; their
// sum is 1.
inline std::vector<double> gaussian_weights(double sigma, int radius) {
  std::vector<double> weights;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) {
    weights.push_back(exponential(-double(i * i) / (2 * sigma * sigma)));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace glassbox::views
