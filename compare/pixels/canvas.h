// Two pictures of different sizes on one canvas, so that they can be compared where both are.
#pragma once

#include <cstdint>

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/compare/pixels/selection.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

enum class Alignment : std::uint8_t {
  kTopLeft,  // the top left corners lie on each other
  kCentre,   // the centres do, or the smaller one lies half a pixel higher or further left
  kBest,     // where the pictures differ least
};

// The smallest canvas that has both pictures. Positions are counted from its top left corner.
struct Canvas {
  int width = 0, height = 0;  // px
  PixelBox reference, test;   // where the pictures lie
  PixelBox overlap() const { return intersection(reference, test); }
  friend bool operator==(const Canvas&, const Canvas&) = default;
};

// Places two pictures so that the overlap is as wide as the narrower one and as high as the lower
// one. For kBest they must have the same channels and format.
Canvas place_on_canvas(const StoredImage& reference, const StoredImage& test, Alignment alignment);

// The picture at its place; the samples of the rest are 0.
StoredImage on_canvas(StoredImage image, const Canvas& canvas, const PixelBox& place);

// The pixels of the overlap that `own`, a selection of the reference's pixels, has.
Selection on_canvas(const Selection& own, const Canvas& canvas);

// Where the test's top left corner lies in the reference's pixels if the overlap differs least: the
// sum of each pixel's largest difference in steps; the first one by rows, if there are several.
// In each direction the smaller picture lies within the larger one, so a coordinate is negative or
// 0 where the test is the larger one. Every place is tried, at first on some pixels; the best of
// these are compared completely.
PixelPosition best_place(const StoredImage& reference, const StoredImage& test);

}  // namespace glassbox
