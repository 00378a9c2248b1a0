// The skewed pair from an unskewed one by cutting (S0-08): draw wider than needed, lay the pictures over each other
// until what should be in the window coincides, and trim.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// Two parallel cameras with the centre's frustum widened to both sides, W + shift columns of the centre's pixels.
struct AlignAndCrop {
  View left, right;
  // The parallax of infinity, s a W/f px with a the entry (0, 0) of the projection, and the columns that are cut for
  // it: the nearest whole number.
  double shift_px = 0;
  int shift = 0;
  // Columns first .. first + W - 1 of each picture are kept.
  int left_first = 0, right_first = 0;
};

// Where shift_px is a whole number (even or odd), cutting shifts every vertex by whole pixels against eye_view's, and
// the pictures are the same but for rounding; else each eye's picture is off by half of shift_px - shift, a quarter
// of a pixel at most. Errors: a parallel projection, whose unskewed pair has no parallax to cut; a viewport that is
// not the whole picture from (0, 0); more than kMaxImageSide columns. The pair counts as checked.
Result<AlignAndCrop> align_and_crop(const View& centre, const StereoPair& pair);

}  // namespace glassbox
