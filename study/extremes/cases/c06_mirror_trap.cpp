#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/projection.h>

#include "exact/camera.h"
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/extremes/common/screen_scene.h"
#include "study/naive/camera.h"

namespace glassbox::study {
namespace c06 {

using Camera60 = Transform<Clip, World> (*)(const WorldPoint& eye, const WorldPoint& target,
                                            const WorldVector& up);

// The outline of the letter F in the plane z = 0, as seen from the front.
constexpr double kGlyph[][2] = {{0, 0}, {0, 2}, {1, 2}, {1, 1.75}, {0.75, 1}, {0.25, 1}};

Outcome measure_error(Camera60 camera) {
  const WorldPoint eye{1, 2, 6}, target{0.5, 1, 0};
  const WorldVector up{0, 1, 0};
  const auto clip_from_world = camera(eye, target, up);
  const auto eye_from_world = exact::look_at(eye, target, up);
  const exact::Decimal cotangent = exact::sqrt(exact::Decimal(3));  // cotangent of 30 degrees
  WorstError worst;
  for (const auto& [x, y] : kGlyph) {
    const auto p = eye_from_world * exact::exactly<exact::Decimal>(WorldPoint(x, y, 0));
    const Point<Clip, double> c = clip_from_world * WorldPoint(x, y, 0);
    // The entries of both matrices are right to 16 u (u is the unit roundoff), the coordinates are
    // below 8 and w is above 5. A coordinate in clip space is a sum of 4 products, so it is right
    // to 16 u * 4 * 8; the quotient by w is right to twice that over 5.
    constexpr double kBound = 2 * 16 * 4 * 8 / 5.0 * unit_roundoff<double>;
    worst.add(exact::error_of(c.x / c.w, cotangent * p[0] / -p[2]), kBound, "x of the glyph");
    worst.add(exact::error_of(c.y / c.w, cotangent * p[1] / -p[2]), kBound, "y of the glyph");
  }
  return worst.outcome();
}

Transform<Clip, Eye> lens() {
  return perspective_degrees(60, 1, {1, 100}).value();
}
Transform<Clip, World> ours(const WorldPoint& eye, const WorldPoint& target,
                            const WorldVector& up) {
  return lens() * look_at(eye, target, up).value();
}

// Exactly as on the slide (S3.37): a rotation without reflection turns the gaze to +z, and the
// projection looks along +z (E7).
Transform<Clip, World> slide_37(const WorldPoint& eye, const WorldPoint& target,
                                const WorldVector& up) {
  const Transform<Eye, World> view = naive::axis_angle_view(eye, target, up, {0, 0, 1});
  return alpha_beta(30, 1, 1, 100).value() * Transform<EyeLeft, World>(view.columns);
}

Transform<Clip, World> with_axes(const WorldPoint& eye, const WorldPoint& target,
                                 const WorldVector& up, double u_sign, double v_sign) {
  const WorldVector n = naive::normalise(eye - target);
  const WorldVector u = naive::normalise(cross(up, n));
  return lens() * naive::view_matrix(u * u_sign, cross(n, u) * v_sign, n, eye);
}
Transform<Clip, World> u_reversed(const WorldPoint& eye, const WorldPoint& target,
                                  const WorldVector& up) {
  return with_axes(eye, target, up, -1, 1);
}
Transform<Clip, World> v_reversed(const WorldPoint& eye, const WorldPoint& target,
                                  const WorldVector& up) {
  return with_axes(eye, target, up, 1, -1);
}

// The letter F itself, made of three strokes: every reflection of it looks different.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference letter([] {
    Mesh mesh;
    for (const auto& [left, bottom, right, top] : {std::array{0.0f, 0.0f, 0.25f, 2.0f},
                                                   {0.25f, 1.75f, 1.0f, 2.0f},
                                                   {0.25f, 1, 0.75f, 1.25f}}) {
      add_triangle(mesh, {Point<Object>{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}});
      add_triangle(mesh, {Point<Object>{left, bottom, 0}, {right, top, 0}, {left, top, 0}});
    }
    return make_ray_scene(scene_of(std::move(mesh), unlit_material()),
                          Aim{{1, 2, 6}, {0.5, 1, 0}, {0, 1, 0}},
                          PerspectiveLens{radians_from_degrees(60), 1, 100.0}, 96);
  }());
  return letter.measure_error(engine);
}

}  // namespace c06

ExtremeCase c06_mirror_trap() {
  using namespace c06;
  return {
      .id = "C-06",
      .name = "The mirror trap",
      .construction = "six points of the letter F, seen from (1, 2, 6) at 60 degrees",
      .stage = "look-at",
      .right_answer =
          "the points are where the UVN construction of 50 digits puts them; a rotation that turns "
          "the gaze to +z mirrors the picture (E7)",
      .unit = "NDC",
      .oracle = Oracle::kExtended,
      .ours = {"look_at and perspective", [] { return measure_error(ours); }},
      .naive = {"the matrix exactly as slide S3.37 gives it",
                [] { return measure_error(slide_37); }},
      .mutants = {{"U = N x up instead of up x N", [] { return measure_error(u_reversed); }},
                  {"V = U x N instead of N x U", [] { return measure_error(v_reversed); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
