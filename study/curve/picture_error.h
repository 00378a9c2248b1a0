// The error of a whole picture, compared with a reference picture.
#pragma once

#include <glassbox/images/image.h>

namespace glassbox::study {

struct PictureError {
  double rms = 0;    // root mean square over red, green and blue; 1 is the whole range of a byte
  int largest = 0;   // the largest error of a channel, in steps of a byte
  double wrong = 0;  // the fraction of pixels with a channel that is off by more than kUnseenSteps
  // The mean of the metric FLIP, 0 to 1: how visible the difference is when one picture replaces
  // the other.
  double flip = 0;
};

// Differences of fewer steps of a byte are hardly visible beside an edge.
inline constexpr int kUnseenSteps = 8;

// Both pictures must have the same size and be opaque.
PictureError picture_error(const Image<Rgba8>& picture, const Image<Rgba8>& reference);

}  // namespace glassbox::study
