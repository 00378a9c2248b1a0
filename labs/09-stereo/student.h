// Lab 9: two eyes and one picture for both. The contracts of the six functions that you write in
// student.cpp.
//
// Eye space: x right, y up, the eye looks down -z. A *distance* is measured along the gaze and
// positive in front of the eye: distance = -z. Column vectors: p_clip = clip_from_eye * p_eye,
// M.at(row, column). u = 2^-53 is the unit roundoff of double.
#pragma once

#include <array>
#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/images/image.h>

namespace lab_09 {

// The types of <glassbox/base/spaces.h> and <glassbox/images/image.h>, which come with glassbox;
// this is all that you need:
//   Transform<Target, Source>  a 4 x 4 matrix of doubles, at first the identity: m.at(row, column),
//                              counted from 0
//   Image<Rgba8>               image.width, image.height; image.at(x, y), from the top left;
//                              Image<Rgba8>(width, height, colour) has one colour everywhere
//   Rgba8                      c.r, c.g, c.b, c.a: 0 to 255
using glassbox::Clip;
using glassbox::Eye;
using glassbox::Image;
using glassbox::Point;
using glassbox::Rgba8;
using glassbox::Transform;

enum class Side { kLeft, kRight };

// The left eye is `half_separation` = s to the left of the centre camera, the right eye is s to the
// right of it. A point at the distance `window` = f has no parallax. Lengths are in world units. s
// >= 0; f > 0, and f may be infinite: then the eyes have no skew.
struct Pair {
  double half_separation = 0, window = 1;
};

// What both eyes' pictures have in common: `scale` is the entry (0, 0) of the projection, d/h in
// the slides; `width` is in pixels.
struct Picture {
  double scale = 1;
  int width = 640;
};

// Task 9.1. The projection of one eye: first the skew x' = x + s (1 - distance/f), with -s in place
// of s for the right eye, then the centre camera's projection, clip_from_eye. The centre's
// projection may be of any kind: with its window off the middle, parallel, with reversed depth. The
// rows of y, z and w have exactly the centre's numbers, and without separation the whole matrix has
// them (-0 counts as equal to 0).
// Error bound of the row of x: 8 u times the largest of |m00 s/f|, |m02|, |m00 s| and |m03|, where
// m is clip_from_eye.
Transform<Clip, Eye> eye_projection(const Transform<Clip, Eye>& clip_from_eye, const Pair& pair,
                                    Side side);

struct Parallax {
  double px = 0;
  double percent = 0;  // of the picture's width
};

// Task 9.2. The parallax of a point at this distance: its x in the right eye's picture minus its x
// in the left one's. The centre's projection is a perspective one. 0 < distance, which may be
// infinite. Error bound: 16 u |parallax| in pixels, and likewise in per cent, also for points near
// the window. Lengths that are not 0 or infinite are from 10^-100 to 10^100; or half_separation,
// window and distance are all near 10^200.
Parallax parallax_at(const Pair& pair, const Picture& picture, double distance);

// A corner in the clip space of both eyes, for which y, z and w are the same. The left eye sees
// what has -w <= left_x <= w, -w <= y <= w and 0 <= z <= w; the right eye has right_x in place of
// left_x.
struct StereoPoint {
  float left_x = 0, right_x = 0, y = 0, z = 0, w = 0;
};

enum class Verdict { kUnknown = -1, kDraw = 1, kCull = 2 };

// Task 9.3. One verdict for both eyes. An eye misses a triangle if all three corners are outside
// the same one of the six planes of the eye's frustum; a corner on a plane is not outside it. kCull
// if both eyes miss the triangle, even if with different planes; otherwise kDraw. All numbers are
// finite.
Verdict cull(const std::array<StereoPoint, 3>& triangle);

// A fragment that an eye draws at one pixel. 0 <= depth <= 1, smaller is nearer.
struct Fragment {
  int x = 0, y = 0;  // from the left, from the top
  float depth = 0;
  Rgba8 colour;
};

struct Channels {
  bool r = false, g = false, b = false;
};

// A picture made from the fragments of both eyes, in the order in which they are drawn. Every
// channel is in one of the two masks.
struct Anaglyph {
  int width = 0, height = 0;
  Rgba8 background;  // the background of both eyes
  Channels left_mask{true, false, false}, right_mask{false, true, true};
  std::vector<Fragment> left, right;
};

// Task 9.4. One colour buffer, in which each eye writes only the channels of its mask. Each channel
// must be that of the eye's own picture: the colour of the nearest fragment of the pixel, the first
// one among equally near ones, or the background if the pixel has no fragment. Alpha is not
// compared. Exact.
Image<Rgba8> draw_anaglyph(const Anaglyph& anaglyph);

using Colour = std::array<double, 3>;  // red, green and blue as light, 0 to 1

// A change of colour c to c' = b + (1 - b) ((1 - k) c + k Y(c)), Y = 0.299 red + 0.587
// green + 0.114 blue.
struct Recolour {
  double desaturate = 0, brighten = 0;  // k and b, 0 to 1
};

// Rows: red, green and blue as shown. Columns: red, green and blue of the left eye, then of the
// right eye.
using Matrix = std::array<std::array<double, 6>, 3>;

// Task 9.5. The colour shown for the colours of the two eyes: first both are recoloured, then
// multiplied by the matrix, then each channel is clamped to 0 .. 1. The absolute values
// of each row of the matrix add up to at most 2. Error bound of each channel: 32 u.
Colour anaglyph_colour(const Matrix& matrix, const Recolour& recolour, const Colour& left,
                       const Colour& right);

// A frame of a sequence: everything visible is between the distances `nearest` and `farthest`
// (which may be infinite), 0 < nearest <= farthest. `window` is the distance without parallax.
struct Frame {
  double nearest = 1, farthest = 1, window = 1;
};

// The largest |parallax| allowed in front of the window and behind it, in pixels, >= 0.
struct Budget {
  double in_front_px = 0, behind_px = 0;
};

// Task 9.6. Half the separation of the eyes for each frame, by a camera that does not know the next
// frame. The limit of a frame is the largest s for which the parallax at its nearest and at its
// farthest distance stays within the budget, but at most window/scale, which is half the width that
// the picture shows at the window. The first frame gets its limit. If a limit is not above the last
// frame's separation, the separation is the limit at once; if it is above, the separation grows by
// the fraction 1/(1 + release_frames) of the difference.
// Every frame has a finite limit, and release_frames >= 0 need not be a whole number.
// Error bound: 64 (1 + release_frames) u times the largest separation of the frames.
std::vector<double> comfortable_separations(const Picture& picture, const Budget& budget,
                                            const std::vector<Frame>& frames,
                                            double release_frames);

}  // namespace lab_09
