// How far a picture is from the right one, over the whole of it.
#pragma once

#include <glassbox/images/image.h>

namespace glassbox::study {

struct PictureError {
  double rms = 0;    // of red, green and blue; 1 for the whole range of a byte
  int largest = 0;   // of a channel, in steps of a byte
  double wrong = 0;  // the share of pixels with a channel off by more than kUnseenSteps
  double flip = 0;   // the mean of FLIP, 0 to 1: what is seen when the two are shown in turns
};

// Less is hardly seen beside an edge.
inline constexpr int kUnseenSteps = 8;

// Both have the same size, and are opaque.
PictureError picture_error(const Image<Rgba8>& picture, const Image<Rgba8>& reference);

}  // namespace glassbox::study
