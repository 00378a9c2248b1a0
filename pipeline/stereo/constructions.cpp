#include <glassbox/pipeline/stereo/constructions.h>

#include <cmath>
#include <limits>

#include <glassbox/base/elementary.h>
#include <glassbox/pipeline/dialects.h>

namespace glassbox {
namespace {

// A camera that moves by -shift along x moves the world by +shift in eye space.
Transform<Eye, Eye> translation(double shift) {
  Transform<Eye, Eye> m;
  m.at(0, 3) = shift;
  return m;
}

// The row of clip_from_eye that computes the clip depth z' = scale z_eye + offset.
struct DepthRow {
  double scale, offset;
};
DepthRow depth_row(const View& view) {
  return {view.clip_from_eye.at(2, 2), view.clip_from_eye.at(2, 3)};
}

// Returns -a s focus/shift, in the letters of pair_of_clip_skew (constructions.h). A clip skew
// moves NDC x by shift (1 - depth/focus). A skew in eye space moves it by a s (1/z - 1/f) for
// perspective, where the depth is B/z - A, and by a s (1 - z/f) for parallel projections, where the
// depth is B - A z. Equal coefficients of 1/z (or of z) give B (or A f).
double shift_ratio(const View& centre, double window) {
  const DepthRow depth = depth_row(centre);
  return centre.perspective ? depth.offset : depth.scale * window;
}

}  // namespace

Result<View> off_axis_view(const View& centre, const StereoPair& pair, Side side) {
  if (!centre.perspective) {
    return fail("off-axis frustum", "the projection is parallel",
                "use the skew matrix, which makes it oblique");
  }
  const double s = eye_shift(pair, side), n = centre.near;
  // The projection has x_clip = a x + b z_eye and w = -z_eye, so on the near plane, at the distance
  // n, the edges -1 and 1 of NDC are at x = n (b -+ 1)/a.
  const auto edge = [&](int axis, double ndc) {
    return n * (centre.clip_from_eye.at(axis, 2) + ndc) / centre.clip_from_eye.at(axis, axis);
  };
  const double shift = s * n / pair.window;
  const Window window{edge(0, -1) + shift, edge(0, 1) + shift, edge(1, -1), edge(1, 1)};
  const Result<Transform<Clip, Eye>> projection =
      frustum(window, {n, centre.far, centre.depth_range});
  if (!projection) return tl::unexpected(projection.error());
  View eye = centre;
  eye.clip_from_eye = *projection;
  eye.eye_from_world = translation(s) * centre.eye_from_world;
  return eye;
}

View translate_and_shear_view(const View& centre, const StereoPair& pair, Side side) {
  const double s = eye_shift(pair, side);
  Transform<Eye, Eye> shear;
  shear.at(0, 2) = s / pair.window;
  View eye = centre;
  eye.clip_from_eye = centre.clip_from_eye * shear;
  eye.eye_from_world = translation(s) * centre.eye_from_world;
  return eye;
}

View clip_skew_view(const View& centre, const ClipSkew& skew, Side side) {
  const double shift = side == Side::kLeft ? skew.shift : -skew.shift;
  Transform<Clip, Clip> skewed;
  skewed.at(0, 2) = -shift / skew.focus;
  skewed.at(0, 3) = shift;
  View eye = centre;
  eye.clip_from_eye = skewed * centre.clip_from_eye;
  return eye;
}

StereoPair pair_of_clip_skew(const View& centre, const ClipSkew& skew) {
  const DepthRow depth = depth_row(centre);
  StereoPair pair;
  pair.window = centre.perspective ? depth.offset / (skew.focus + depth.scale)
                                   : (depth.offset - skew.focus) / depth.scale;
  pair.half_separation =
      -skew.shift * shift_ratio(centre, pair.window) / (centre.clip_from_eye.at(0, 0) * skew.focus);
  return pair;
}

Result<ClipSkew> clip_skew_of_pair(const View& centre, const StereoPair& pair) {
  const DepthRow depth = depth_row(centre);
  ClipSkew skew;
  skew.focus = centre.perspective ? depth.offset / pair.window - depth.scale
                                  : depth.offset - depth.scale * pair.window;
  if (skew.focus == 0) {
    return fail("stereo window",
                "its depth is 0, and a skew in clip space moves all points of depth 0",
                "move the window off that plane, or skew in eye space");
  }
  skew.shift = -pair.half_separation * centre.clip_from_eye.at(0, 0) * skew.focus /
               shift_ratio(centre, pair.window);
  return skew;
}

View toe_in_view(const View& centre, const StereoPair& pair, Side side) {
  const double s = eye_shift(pair, side);
  const double tangent = s / pair.window;
  const double cosine = 1 / hypotenuse(1, tangent), sine = tangent * cosine;
  Transform<Eye, Eye> turn;  // about y; the left camera turns to its right
  turn.at(0, 0) = cosine;
  turn.at(0, 2) = sine;
  turn.at(2, 0) = -sine;
  turn.at(2, 2) = cosine;
  View eye = centre;
  eye.eye_from_world = turn * (translation(s) * centre.eye_from_world);
  return eye;
}

}  // namespace glassbox
