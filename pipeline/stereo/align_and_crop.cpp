#include <glassbox/pipeline/stereo/align_and_crop.h>

#include <cmath>
#include <string>

#include <glassbox/pipeline/number_text.h>

namespace glassbox {
namespace {

// The view of the camera moved by -shift; the picture gets `columns` more pixels of the same size,
// half of them on each side.
View wider_view(const View& centre, double shift, int columns) {
  View view = centre;
  view.eye_from_world.at(0, 3) += shift;
  const double width = double(centre.viewport.width());
  for (int column = 0; column < 4; ++column)
    view.clip_from_eye.at(0, column) *= width / (width + columns);
  view.viewport.right += float(columns);
  return view;
}

}  // namespace

Result<AlignAndCrop> align_and_crop(const View& centre, const StereoPair& pair) {
  if (!centre.perspective) {
    return fail("align and crop",
                "the projection is parallel, and the pictures of two parallel cameras are alike",
                "use the skew matrix instead (option --eyes-by skew)");
  }
  const float width = centre.viewport.width();
  if (centre.viewport.left != 0 || centre.viewport.top != 0 || width != std::floor(width)) {
    return fail("align and crop", "the viewport is not a whole picture",
                "give whole pixels from (0, 0)");
  }
  AlignAndCrop cut;
  cut.shift_px = pair.half_separation * centre.clip_from_eye.at(0, 0) * double(width) / pair.window;
  if (!(double(width) + cut.shift_px <= kMaxImageSide)) {
    return fail(
        "align and crop",
        "the pictures would be " + number_text(double(width) + cut.shift_px) + " pixels wide",
        "keep the picture's width and the shift within " + std::to_string(kMaxImageSide));
  }
  cut.shift = int(std::lround(cut.shift_px));
  cut.left = wider_view(centre, eye_shift(pair, Side::kLeft), cut.shift);
  cut.right = wider_view(centre, eye_shift(pair, Side::kRight), cut.shift);
  // The columns to keep begin after the border of shift/2. They begin another shift/2 later for the
  // left eye and shift/2 earlier for the right eye, which is the difference that the skew makes.
  cut.left_first = cut.shift;
  cut.right_first = 0;
  return cut;
}

}  // namespace glassbox
