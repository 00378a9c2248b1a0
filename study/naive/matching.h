// Wrong ways to do dense stereo matching.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <glassbox/images/image.h>

#include "views/matching/calibration.h"
#include "views/matching/settings.h"

namespace glassbox::study::naive {

// Matches by the smallest difference of two single grey values along the row. Positions outside the
// right picture are clamped to its border, and every pixel gets a disparity, even if it has no
// match.
inline Image<float> match_clamped(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                  const views::DisparityRange& range) {
  Image<float> disparity(left.width, left.height);
  for (int y = 0; y < left.height; ++y) {
    for (int x = 0; x < left.width; ++x) {
      int least = std::numeric_limits<int>::max();
      for (int d = range.first; d <= range.last; ++d) {
        const int column = std::clamp(x - d, 0, right.width - 1);
        const int cost = std::abs(left.at(x, y).g - right.at(column, y).g);
        if (cost >= least) continue;
        least = cost;
        disparity.at(x, y) = float(d);
      }
    }
  }
  return disparity;
}

// The root mean square error over all pixels, including those whose true disparity is unknown.
inline double rms_of_all(const Image<float>& disparity, const Image<float>& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i)
    sum += std::pow(double(disparity.pixels[i]) - double(truth.pixels[i]), 2);
  return std::sqrt(sum / double(truth.pixels.size()));
}

// The depth f B/d, from focal length f, baseline B and disparity d. It assumes that the principal
// points are in the same column, which parallel axes alone do not guarantee.
inline double depth_without_offset(double disparity, const views::Calibration& calibration) {
  return calibration.focal_px * calibration.baseline / disparity;
}

}  // namespace glassbox::study::naive
