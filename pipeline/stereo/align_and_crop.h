// Makes the skewed pair from an unskewed one by cropping (S0-08): draw the pictures wider than
// needed, lay them over each other so that points in the window coincide, and crop.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// Two parallel cameras with the centre's frustum widened on both sides: their pictures have W +
// shift columns, W being the columns of the centre's picture.
struct AlignAndCrop {
  View left, right;
  // The parallax at infinity, s a W/f px, where s is half the separation, a the entry (0, 0) of the
  // projection and f the distance of the stereo window. `shift` is the nearest whole number, the
  // number of columns that are cropped.
  double shift_px = 0;
  int shift = 0;
  // Columns first .. first + W - 1 of each picture are kept.
  int left_first = 0, right_first = 0;
};

// Where shift_px is a whole number (even or odd), cropping shifts every vertex by whole pixels
// compared with eye_view's, and the pictures are the same except for rounding. Otherwise each eye's
// picture is off by half of shift_px - shift, a quarter of a pixel at most. Errors: a parallel
// projection, whose unskewed pair has no parallax to crop; a viewport that is not the whole picture
// from (0, 0); more than kMaxImageSide columns. The pair must have passed check_pair.
Result<AlignAndCrop> align_and_crop(const View& centre, const StereoPair& pair);

}  // namespace glassbox
