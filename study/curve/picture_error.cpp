#include "study/curve/picture_error.h"

#include <algorithm>
#include <cstdlib>

#include "study/recommend/pictures.h"

#include <glassbox/compare/metrics/flip.h>
#include <glassbox/images/stored_image.h>

namespace glassbox::study {

namespace {

int largest_step(const Rgba8& a, const Rgba8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

double mean_flip(const Image<Rgba8>& picture, const Image<Rgba8>& reference) {
  const StoredImage test = as_stored(picture), right = as_stored(reference);
  const Selection all(picture.width, picture.height);
  return flip(PicturePair{right, test, all}).mean;
}

}  // namespace

PictureError picture_error(const Image<Rgba8>& picture, const Image<Rgba8>& reference) {
  PictureError error;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const int step = largest_step(picture.pixels[i], reference.pixels[i]);
    error.largest = std::max(error.largest, step);
    wrong += step > kUnseenSteps;
  }
  error.rms = color_error(picture, reference);
  error.wrong = double(wrong) / double(picture.pixels.size());
  error.flip = mean_flip(picture, reference);
  return error;
}

}  // namespace glassbox::study
