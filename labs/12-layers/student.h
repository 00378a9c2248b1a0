// Lab 12: a layered depth image and a second eye. The contracts of the six functions that you write
// in student.cpp.
//
// Screen space: pixels from the top left, y down; pixel (i, j) has its centre at
// (i + 1/2, j + 1/2). *Depth* grows towards the eye: it is near / distance, 1 at the near plane and
// towards 0 far away. Column vectors: p_screen = screen_from_world * p_world, M.at(row, column). u
// is the unit roundoff, 2^-24 of float and 2^-53 of double.
#pragma once

#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/images/image.h>

namespace lab_12 {

// The types of <glassbox/base/spaces.h> and <glassbox/images/image.h>, which come with glassbox;
// this is all that you need:
//   Transform<Target, Source>  a 4 x 4 matrix of doubles, at first the identity: m.at(row, column),
//                              counted from 0; a * b: a Transform<C, B> times a
//                              Transform<B, A> is a Transform<C, A>
//   Image<Rgba8>               image.width, image.height; image.at(x, y), from the top left;
//                              Image<Rgba8>(width, height, colour) has one colour everywhere
//   Rgba8                      c.r, c.g, c.b, c.a: 0 to 255
using glassbox::Image;
using glassbox::Rgba8;
using glassbox::Screen;
using glassbox::Transform;
using glassbox::World;

// A sample of a pixel: one of the surfaces on the pixel's line of sight. 0 < depth <= 1.
struct Sample {
  int x = 0, y = 0;
  float depth = 1;
  Rgba8 colour;
};

// The samples of a picture, packed for drawing: rows from the bottom to the top, pixels from left
// to right, the samples of a pixel from back to front.
struct Layers {
  int width = 0, height = 0;
  // width * height + 1 numbers: the samples of the i-th pixel (from the bottom left, row by row)
  // begin at first[i] and end before first[i + 1].
  std::vector<int> first;
  std::vector<float> depth;
  std::vector<Rgba8> colour;
};

// Task 12.1. Packs samples, which come in any order and are all inside the picture. A sample is
// *near* to one in front of it, whose depth is z, if the difference of the depths is at most the
// product epsilon z, both computed in double. In each pixel, from front to back: the first sample
// is kept and absorbs all that are near to it, then the first of the rest is kept and absorbs all
// that are near to it, and so on; an absorbed sample absorbs nothing. Among equal depths the first
// of `samples` is in front. Exact.
Layers pack(int width, int height, const std::vector<Sample>& samples, double epsilon);

// A homogeneous position in a picture: (x w, y w, z w, w), with x and y in pixels, z the depth.
// w <= 0 is behind the eye.
struct Warped {
  float x = 0, y = 0, z = 0, w = 0;
};

// Task 12.2. The matrix that maps (x1, y1, z1, 1), a pixel of the first eye with its depth, to
// (x2 w, y2 w, z2 w, w) of the second eye. `first` and `second` map the world to the pictures of
// the two eyes. In double.
// Error bound of a row's entries: 256 u times the largest entry in that row of
// |second| |first^-1| |first| |first^-1|, where |.| makes all entries of a matrix positive.
Transform<Screen, Screen> warp_matrix(const Transform<Screen, World>& first,
                                      const Transform<Screen, World>& second);

// Task 12.3. Row y of the first picture, warped. depths[x] are the depths of the samples of pixel
// (x, y). One answer for each sample, pixels from left to right, the samples of a pixel in their
// order; in float.
// Error bound of each coordinate: 72 u (u of float) times the largest value that |start| at any of
// the row's pixels, or |start| + |z1 column| at any of its samples, has for that coordinate, where
// start is warp * (x + 1/2, y + 1/2, 0, 1) and column the third column of warp. Rows may be 16,384
// px long. Nothing overflows or underflows: depths and entries of warp that are not 0 have
// magnitudes of 2^-64 to 2^32.
std::vector<Warped> warp_row(const Transform<Screen, Screen>& warp, int y,
                             const std::vector<std::vector<float>>& depths);

struct Splat {
  double side = 0;  // px
  bool is_cut = false;
};

// Task 12.4. The size at which a sample is drawn: l = focal_ratio / w sqrt(cosine_second /
// cosine_first), but at least 1 px and at most 64; is_cut if l is larger than 64. focal_ratio > 0
// is F2/F1, the second eye's focal length over the first eye's; w > 0 is d2/d1, the ratio of the
// distances. The cosines, 0 to 1, are those of the angles between the surface's normal and the
// lines to the two eyes. A surface that the first eye saw exactly edge-on (cosine 0) is cut to 64
// px. All numbers are below 2^128 and at least 2^-149; a cosine may also be 0. So nothing overflows
// in double. Error bound of the side: 8 u side; where l is not 64 but closer to 64 than that bound,
// is_cut may be either.
Splat splat_size(double focal_ratio, double w, double cosine_first, double cosine_second);

// Task 12.5. The order in which the columns 0 .. count - 1 of the first picture (or its rows) are
// visited, so that of two samples that hide each other the nearer one to the second eye is visited
// later. The epipole is where the first picture shows the second eye. With w > 0 the second eye is
// in front of the first eye and is seen at the column epipole / w. With w < 0 it is behind the
// first eye, and epipole / w is where the line through both eyes meets the picture. With w = 0 it
// is to the side: to the right (or below) if epipole > 0. The position of a column is its centre.
// First come all columns that are visited with growing numbers, then all that are visited with
// falling numbers. A column whose centre is the epipole is visited with falling numbers. Exact,
// also for a centre that is one rounding step of `epipole` beside it. epipole and w are not both 0;
// those that are not 0 have magnitudes of 2^-900 to 2^901, and count is at least 0.
std::vector<int> visiting_order(double epipole, double w, int count);

// A sample on its way into the second picture: a square around its position.
struct Placed {
  Warped at;
  double side = 1;  // px
  Rgba8 colour;
};

enum class Hiding {
  kNearest,  // the nearest sample of a pixel stays, the first among equally near ones
  kLast,     // the last sample of a pixel stays
};

struct Canvas {
  int width = 0, height = 0;
  Rgba8 background;
  Hiding hiding = Hiding::kNearest;
  std::vector<Placed> samples;
};

// Task 12.6. The second picture. A sample is drawn if w > 0 and its depth z w / w is at most 1: not
// if it is behind the eye or nearer than the near plane. It covers those pixels whose centres are
// in (x - side/2, x + side/2] and (y - side/2, y + side/2], with x = x w / w in double, and y
// likewise. It may be outside the picture, or as far away as a float can express; its depth may be
// 0 or below. A side has any size, 0 (no pixels) or more. Exact: no pixel centre is within 2^-20 px
// of an edge of the square, unless x, y and side have so few digits that nothing is rounded.
Image<Rgba8> draw(const Canvas& canvas);

}  // namespace lab_12
