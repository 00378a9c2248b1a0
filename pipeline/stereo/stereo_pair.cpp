#include <glassbox/pipeline/stereo/stereo_pair.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/number_text.h>

namespace glassbox {
namespace {

Result<void> check_window(const View& centre, double window) {
  const std::string cause = "it is at the distance " + number_text(window);
  if (std::isnan(window)) return fail("stereo window", cause, "give a distance");
  if (!(window > 0)) {
    return fail("stereo window", cause + ", which is not in front of the camera",
                "give a positive distance along the gaze");
  }
  if (std::isinf(window)) {
    if (centre.perspective) return {};
    return fail("stereo window", cause + ", where a parallel projection has no parallax anywhere",
                "give the distance of what should be in the plane of the screen");
  }
  if (window < centre.near) {
    return fail("stereo window",
                cause + ", nearer than the near plane at " + number_text(centre.near),
                "move the window away, or the near plane closer");
  }
  if (window > centre.far) {
    return fail("stereo window", cause + ", beyond the far plane at " + number_text(centre.far),
                "bring the window closer, or move the far plane away");
  }
  return {};
}

Result<void> check_separation(const View& centre, const StereoPair& pair) {
  const double s = pair.half_separation;
  const std::string cause = "half of it is " + number_text(s);
  if (!std::isfinite(s)) return fail("eye separation", cause, "give a finite number");
  if (s < 0) {
    return fail("eye separation",
                cause + ", which exchanges the eyes, so that near objects would look far",
                "give a positive number");
  }
  const double half_width = window_half_width(centre, pair.window);
  if (s > half_width) {
    return fail("eye separation",
                cause + ", but half of the picture's width at the window is only " +
                    number_text(half_width) +
                    ", so distant objects would be in only one eye's picture",
                "give a smaller separation; a thirtieth of the window's distance is usual");
  }
  return {};
}

// The stages work in float: an entry that is not zero has to be a normal float.
Result<void> check_float_range(const View& eye) {
  for (const int column : {2, 3}) {
    const double size = std::abs(eye.clip_from_eye.at(0, column));
    if (size == 0 ||
        (size >= std::numeric_limits<float>::min() && size <= std::numeric_limits<float>::max()))
      continue;
    return fail("eye separation",
                "with it the matrix entry (0, " + std::to_string(column) + ") is " +
                    number_text(eye.clip_from_eye.at(0, column)) +
                    ", which is too large or too small for a float",
                "choose a separation and a window of more ordinary size, or 0 for no stereo");
  }
  return {};
}

}  // namespace

double window_half_width(const View& centre, double window) {
  const double distance = centre.perspective ? std::min(window, centre.far) : 1;
  return distance / std::abs(centre.clip_from_eye.at(0, 0));
}

Result<void> check_pair(const View& centre, const StereoPair& pair) {
  if (pair.half_separation == 0) return {};
  if (const Result<void> ok = check_window(centre, pair.window); !ok) return ok;
  if (const Result<void> ok = check_separation(centre, pair); !ok) return ok;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (const Result<void> ok = check_float_range(eye_view(centre, pair, side)); !ok) return ok;
  }
  return {};
}

View eye_view(const View& centre, const StereoPair& pair, Side side) {
  View eye = centre;
  if (pair.half_separation == 0) return eye;
  eye.clip_from_eye = centre.clip_from_eye * stereo_skew(eye_shift(pair, side), pair.window);
  return eye;
}

}  // namespace glassbox
