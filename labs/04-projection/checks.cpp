// The expected answers of lab 4, computed by the pipeline's own matrices, and by exact rationals.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exact/number.h"
#include "labs/04-projection/cases.h"
#include "labs/framework/lab.h"

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/projection.h>

namespace glassbox::labs {

namespace {

using exact::Rational;
using lab_04::Dialect;

constexpr double kU = unit_roundoff<double>;

// ---- 4.1 to 4.3: matrices ----

Expected projection(const Transform<Clip, Eye>& m, double roundings) {
  Expected expected = matrix("clip_from_eye", 4, entries(m));
  double largest = 0;
  for (const double each : expected.values) largest = std::max(largest, std::abs(each));
  expected.bound = roundings * kU * largest;
  return expected;
}

// The error bound of an entry in units of the unit roundoff u: tangent, quotients and products
// round 4 or 5 times, in the student's matrix and in ours; student.h allows 16.
constexpr double kEntryRoundings = 16;

Result<Transform<Clip, Eye>> perspective_of(const lab_04::Camera& c) {
  return perspective(c.fovy_radians, c.aspect, {c.near, c.far, DepthRange::kStandard});
}

// The mistake of using OpenGL's clip space, where z goes from -w to w.
ExpectedWithSlip opengl_slip(const Transform<Clip, Eye>& m) {
  const Transform<Clip, Eye> gl(clip_gl_from_clip().columns * m.columns);
  return {"opengl-depth", {projection(gl, 2 * kEntryRoundings)}};
}

Case expect_camera(const lab_04::Camera& camera) {
  const auto& [fovy, aspect, near, far] = camera;
  const Transform<Clip, Eye> right = *perspective_of(camera);
  Transform<Clip, Eye> tangent = right, inverted = right;
  tangent.at(1, 1) = 1 / right.at(1, 1);
  tangent.at(0, 0) = tangent.at(1, 1) / aspect;
  inverted.at(0, 0) = right.at(1, 1) * aspect;
  return {.where = fmt::format("fovy {} radians, aspect {}", fovy, aspect),
          .restated = fmt::format("near {}, far {}; the near plane's window is {:.6g} high", near,
                                  far, 2 * near * std::tan(fovy / 2)),
          .expected = {projection(right, kEntryRoundings)},
          .slipped = {opengl_slip(right),
                      {"tan-cot", {projection(tangent, kEntryRoundings)}},
                      {"inverted-aspect", {projection(inverted, kEntryRoundings)}}}};
}

Case expect_refusals(const std::vector<lab_04::Camera>& cameras) {
  std::vector<double> refused;
  std::string text;
  for (const lab_04::Camera& camera : cameras) {
    const auto made = perspective_of(camera);
    text += fmt::format("{}number {}: fovy {}, aspect {}, near {}, far {}: {}",
                        text.empty() ? "" : "\n", refused.size(), camera.fovy_radians,
                        camera.aspect, camera.near, camera.far,
                        made ? "a view" : "refused, " + made.error().message());
    refused.push_back(made ? 0 : 1);
  }
  return {fmt::format("{} views", cameras.size()), text, {numbers("refused", refused)}};
}

Case expect_box(const lab_04::Box& box) {
  const auto& [left, right, bottom, top, near, far] = box;
  const auto made = orthographic({left, right, bottom, top}, {near, far, DepthRange::kStandard});
  Transform<Clip, Eye> backwards = *made;
  for (int i = 0; i < 3; ++i) backwards.at(i, 3) = -backwards.at(i, 3);
  return {.where = fmt::format("x {} .. {}, y {} .. {}", left, right, bottom, top),
          .restated = fmt::format("near {}, far {}: eye z {} becomes 0, eye z {} becomes 1", near,
                                  far, -near, -far),
          .expected = {projection(*made, kEntryRoundings)},
          .slipped = {opengl_slip(*made),
                      {"translation-sign", {projection(backwards, kEntryRoundings)}}}};
}

// How a dialect's matrix follows from the pipeline's: by a matrix that acts on clip space, after
// the projection, or on eye space, before it.
struct Adaptor {
  glm::dmat4 matrix;
  bool after;
  const char* what;
};

Adaptor adaptor_to(Dialect dialect) {
  switch (dialect) {
    case Dialect::kOpenGl:
      return {clip_gl_from_clip().columns, true, "z from 0 .. w to -w .. w"};
    case Dialect::kReversed:
      return {reverse_depth().columns, true, "z = 0 becomes z = w, and z = w becomes 0"};
    case Dialect::kLeftHandedEye:
      break;
  }
  return {eye_left_from_eye().columns, false,
          "eye (x, y, z) is written (x, y, -z); the same clip point is expected"};
}

Case expect_dialect(const lab_04::DialectCase& input) {
  const Adaptor adaptor = adaptor_to(input.dialect);
  const auto adapted = [&](bool after) {
    const glm::dmat4& m = input.m.columns;
    return projection(Transform<Clip, Eye>(after ? adaptor.matrix * m : m * adaptor.matrix), 4);
  };
  return {.where = input.what,
          .restated = adaptor.what,
          .expected = {adapted(adaptor.after)},
          .slipped = {{"multiplication-order", {adapted(!adaptor.after)}}}};
}

// ---- 4.4 to 4.6: numbers ----

Case expect_divide(const Point<Clip, double>& p) {
  Expected ndc = point("ndc", {}, 0, "NDC");
  double largest = 0;
  for (const double each : {p.x, p.y, p.z}) {
    if (!(p.w > 0)) continue;
    ndc.values.push_back(double(Rational(each) / Rational(p.w)));
    largest = std::max(largest, std::abs(ndc.values.back()));
  }
  ndc.bound = p.w == 1 ? 0 : 4 * kU * largest;
  Expected opengl = ndc;
  if (p.w > 0) {
    opengl.values[2] = 2 * ndc.values[2] - 1;
    opengl.bound = 8 * kU * (largest + 1);
  }
  return {.where = fmt::format("clip ({}, {}, {}, {})", p.x, p.y, p.z, p.w),
          .restated = p.w > 0 ? fmt::format("in front of the eye, at the distance {}", p.w)
                              : "at or behind the eye, or w is not a number",
          .expected = {ndc},
          .slipped = {{"opengl-depth", {opengl}}}};
}

Case expect_screen(const lab_04::ViewportCase& input) {
  const Point<Ndc, double>& p = input.p;
  const lab_04::Rectangle& v = input.viewport;
  const Rational half = Rational(1) / Rational(2);
  const Rational x = Rational(v.left) + (Rational(p.x) + Rational(1)) * half * Rational(v.width);
  const Rational y = Rational(v.top) + (Rational(1) - Rational(p.y)) * half * Rational(v.height);
  const double bound = 8 * kU * std::max(std::abs(v.left) + v.width, std::abs(v.top) + v.height);
  const auto expected = [&](double off) {
    return std::vector{point("screen", {double(x) + off, double(y) + off}, bound, "px"),
                       numbers("depth", {p.z}, 0, "depth")};
  };
  return {.where = fmt::format("NDC ({}, {}, {})", p.x, p.y, p.z),
          .restated = fmt::format(
              "rectangle from ({}, {}), {} x {} pixels; y of NDC runs up, y of the screen down",
              v.left, v.top, v.width, v.height),
          .expected = expected(0),
          .slipped = {{"half-pixel", expected(-0.5)}, {"half-pixel", expected(0.5)}}};
}

// The distance z of the depth d is n f / (f - d (f - n)), with near plane n and far plane f; if the
// far plane is at infinity, it is n / (1 - d).
double exact_distance(const lab_04::DepthCase& input) {
  const Rational d(input.depth), n(input.near);
  if (std::isinf(input.far)) return input.depth == 1 ? input.far : double(n / (Rational(1) - d));
  const Rational f(input.far);
  return double(n * f / (f - d * (f - n)));
}

Case expect_depth(const lab_04::DepthCase& input) {
  const double z = exact_distance(input), near = input.near;
  // In z = n / (1 - d (1 - n/f)) (d: depth; n, f: near and far), the rounding of a number up to 1
  // changes z by u z^2 / n (u: the unit roundoff). At most four numbers up to 1 are rounded, and
  // the quotient; 8 is more. For f = infinity and d = 1 the result is exact.
  const double bound = std::isinf(z) ? 0 : 8 * kU * z * z / near;
  const auto expected = [](double value, double by) {
    return std::vector{numbers("distance", {value}, by, "world units")};
  };
  // The mistake of taking the depth for one in -1 .. 1, as in OpenGL, and mapping it to 0 .. 1
  // first.
  lab_04::DepthCase opengl = input;
  opengl.depth = (input.depth + 1) / 2;
  const double gl = exact_distance(opengl);
  return {
      .where = fmt::format("depth {}, near {}, far {}", input.depth, near, input.far),
      .restated =
          fmt::format("the distance is {}; one step of depth in float is {:.3g} of it there", z,
                      std::isinf(z) ? z : z / near * double(unit_roundoff<float>)),
      .expected = expected(z, bound),
      .slipped = {{"opengl-depth", expected(gl, std::isinf(gl) ? 0 : 16 * kU * gl * gl / near)}}};
}

template <Dialect kDialect>
std::vector<lab_04::DialectCase> projections() {
  return lab_04::in_clip_space(kDialect);
}

}  // namespace

Lab lab_04() {
  using namespace lab_04;
  return {
      4,
      "04-projection",
      "Projection, dialects, viewport",
      {{"4.1", "Perspective", 25},
       {"4.2", "Parallel projection", 15},
       {"4.3", "Dialects", 20},
       {"4.4", "The divide", 15},
       {"4.5", "The viewport", 15},
       {"4.6", "A distance from a depth", 10}},
      {check("perspective views", "4.1", "clip", cameras, expect_camera),
       check("views that cannot be", "4.1", "clip", refusals, expect_refusals),
       hidden_check("views of extreme shape", "4.1", "clip", stiff_cameras, expect_camera),
       check("parallel views", "4.2", "clip", boxes, expect_box),
       hidden_check("boxes far from the gaze", "4.2", "clip", more_boxes, expect_box),
       check("OpenGL's clip space", "4.3", "clip", projections<Dialect::kOpenGl>, expect_dialect),
       check("reversed depth", "4.3", "clip", projections<Dialect::kReversed>, expect_dialect),
       check("a left-handed eye", "4.3", "clip", projections<Dialect::kLeftHandedEye>,
             expect_dialect),
       check("points divided by w", "4.4", "NDC", points, expect_divide),
       hidden_check("more points divided by w", "4.4", "NDC", random_points, expect_divide),
       check("points on a picture of 640 x 480", "4.5", "screen", on_the_picture, expect_screen),
       hidden_check("other rectangles of the screen", "4.5", "screen", viewports, expect_screen),
       check("distances from depths", "4.6", "depth", depths, expect_depth),
       hidden_check("distances from depths close to 1", "4.6", "depth", stiff_depths,
                    expect_depth)}};
}

}  // namespace glassbox::labs
