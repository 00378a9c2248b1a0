// The expected answers of lab 4, computed by exact numbers and by the pipeline's adaptors.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "exact/number.h"
#include "labs/04-projection/generators.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/projection.h>

namespace glassbox::labs {

namespace {

using exact::Decimal;
using exact::Rational;
using lab_04::Dialect;

constexpr double kU = unit_roundoff<double>;

// ---- 4.1 to 4.3: matrices ----

// A matrix of which each entry may be off by so many unit roundoffs of its own size.
Expected projection(const Transform<Clip, Eye>& m, double roundings) {
  Expected expected = matrix("clip_from_eye", 4, entries(m));
  std::vector<double> bounds;
  for (const double each : expected.values) bounds.push_back(roundings * kU * std::abs(each));
  return with_bounds(std::move(expected), std::move(bounds));
}

// What a mistake leads to: each entry may be off by the largest bound.
Expected slipped_projection(const Transform<Clip, Eye>& m, double roundings) {
  Expected expected = projection(m, roundings);
  expected.bounds.clear();
  return expected;
}

// The entries of a view and of a box are quotients and products of numbers that are exact or
// rounded once. cot / aspect is off by 4 u of its size, of which the tangent has 2 u, and the other
// entries by at most 3 u. Sums and differences are those of given numbers, so nothing that was
// rounded cancels in them, and an entry of 0 is exact. student.h allows 16 u.
constexpr double kEntryRoundings = 16;

Result<Transform<Clip, Eye>> perspective_of(const lab_04::Camera& c) {
  return perspective(c.fovy_radians, c.aspect, {c.near, c.far, DepthRange::kStandard});
}

// The cotangent of half an angle, with 50 digits.
Decimal cot_half_of(double fovy) {
  return Decimal(1) / exact::tan(Decimal(fovy) / Decimal(2));
}

// The matrix of a valid view, each entry rounded once. `N` is the type in which it is computed, and
// cot(fovy / 2) is given.
template <class N>
Transform<Clip, Eye> view_of(const N& cot, const lab_04::Camera& c) {
  const N near(c.near);
  const N alpha = std::isinf(c.far) ? N(1) : N(c.far) / (N(c.far) - near);
  Transform<Clip, Eye> m;
  m.at(0, 0) = double(cot / N(c.aspect));
  m.at(1, 1) = double(cot);
  m.at(2, 2) = double(-alpha);
  m.at(2, 3) = double(-alpha * near);
  m.at(3, 2) = -1;
  m.at(3, 3) = 0;
  return m;
}

// The matrix of a box, each entry rounded once.
template <class N>
Transform<Clip, Eye> box_of(const lab_04::Box& b) {
  Transform<Clip, Eye> m;
  const auto fit = [&m](int row, double low, double high) {
    m.at(row, row) = double(N(2) / (N(high) - N(low)));
    m.at(row, 3) = double(-((N(high) + N(low)) / (N(high) - N(low))));
  };
  fit(0, b.left, b.right);
  fit(1, b.bottom, b.top);
  m.at(2, 2) = double(N(-1) / (N(b.far) - N(b.near)));
  m.at(2, 3) = double(-(N(b.near) / (N(b.far) - N(b.near))));
  return m;
}

// The mistake of using OpenGL's clip space, where z goes from -w to w.
ExpectedWithSlip opengl_slip(const Transform<Clip, Eye>& m) {
  const Transform<Clip, Eye> gl(clip_gl_from_clip().columns * m.columns);
  return {"opengl-depth", {slipped_projection(gl, 2 * kEntryRoundings)}};
}

Case expect_camera(const lab_04::Camera& camera) {
  const auto& [fovy, aspect, near, far] = camera;
  const Transform<Clip, Eye> right = view_of(cot_half_of(fovy), camera);
  Transform<Clip, Eye> tangent = right, inverted = right;
  tangent.at(1, 1) = 1 / right.at(1, 1);
  tangent.at(0, 0) = tangent.at(1, 1) / aspect;
  inverted.at(0, 0) = right.at(1, 1) * aspect;
  return {.where = fmt::format("fovy {} radians, aspect {}", fovy, aspect),
          .restated = fmt::format("near {}, far {}; the near plane's window is {:.6g} high", near,
                                  far, 2 * near * std::tan(fovy / 2)),
          .expected = {projection(right, kEntryRoundings)},
          .slipped = {opengl_slip(right),
                      {"tan-cot", {slipped_projection(tangent, kEntryRoundings)}},
                      {"inverted-aspect", {slipped_projection(inverted, kEntryRoundings)}}}};
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
  const Transform<Clip, Eye> made = box_of<Rational>(box);
  Transform<Clip, Eye> backwards = made;
  for (int i = 0; i < 3; ++i) backwards.at(i, 3) = -backwards.at(i, 3);
  return {.where = fmt::format("x {} .. {}, y {} .. {}", left, right, bottom, top),
          .restated = fmt::format("near {}, far {}: eye z {} becomes 0, eye z {} becomes 1", near,
                                  far, -near, -far),
          .expected = {projection(made, kEntryRoundings)},
          .slipped = {opengl_slip(made),
                      {"translation-sign", {slipped_projection(backwards, kEntryRoundings)}}}};
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

// The matrix in the dialect; or, for the mistake, with the adaptor on the other side. An entry is
// 2 z - w, w - z or -z of exact numbers, which is rounded at most once; student.h allows 4 u.
Expected adapted(const lab_04::DialectCase& input, bool on_its_side) {
  const Adaptor adaptor = adaptor_to(input.dialect);
  const glm::dmat4& m = input.m.columns;
  const Transform<Clip, Eye> made(adaptor.after == on_its_side ? adaptor.matrix * m
                                                               : m * adaptor.matrix);
  return on_its_side ? projection(made, 4) : slipped_projection(made, 4);
}

Case expect_dialect(const lab_04::DialectCase& input) {
  return {.where = input.what,
          .restated = fmt::format("{}\nm, row by row: {}", adaptor_to(input.dialect).what,
                                  fmt::join(entries(input.m), ", ")),
          .expected = {adapted(input, true)},
          .slipped = {{"multiplication-order", {adapted(input, false)}}}};
}

// ---- 4.4 to 4.6: numbers ----

// Whether two numbers have the same bits. Two NaN count as the same.
bool same_bits(double a, double b) {
  return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

// Compares an answer; numbers that must be exact must have the sign of zero, too.
std::optional<Divergence> judge_point(const Expected& expected, const Answer& answer) {
  auto found = compare(expected, answer).first;
  if (found || expected.bound > 0) return found;
  const std::vector<double>& values = *find_field(answer, expected.field);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (same_bits(expected.values[i], values[i])) continue;
    return Divergence{.field = expected.field,
                      .index = i,
                      .element = element_name(expected, i),
                      .expected = expected.values[i],
                      .actual = values[i],
                      .unit = expected.unit,
                      .explanation = "the number must keep its bits, also the sign of zero"};
  }
  return found;
}

// The point divided by w; nothing where there is none. The quotients are rounded once, and so are
// those of the student, or twice, as products with 1/w; a quotient below 2^-1022 in size is rounded
// by up to half of the smallest double. student.h allows 4 u and that double.
Expected ndc_of(const Point<Clip, double>& p) {
  const Expected ndc = point("ndc", {}, 0, "NDC");
  if (!(p.w > 0)) return ndc;
  std::vector<double> values, bounds;
  for (const double each : {p.x, p.y, p.z}) {
    values.push_back(each / p.w);
    bounds.push_back(p.w == 1 ? 0 : 4 * kU * std::abs(values.back()) + lab_04::kSmallest);
  }
  return with_bounds(point("ndc", values, 0, "NDC"), bounds);
}

Case expect_divide(const Point<Clip, double>& p) {
  const Expected ndc = ndc_of(p);
  // The mistake of mapping the depth to -1 .. 1, as in OpenGL.
  Expected opengl = ndc;
  if (p.w > 0) {
    opengl.values[2] = 2 * ndc.values[2] - 1;
    opengl.bound = 2 * ndc.bound + 8 * kU * (1 + std::abs(ndc.values[2]));
    opengl.bounds.clear();
  }
  return {.where = fmt::format("clip ({}, {}, {}, {})", p.x, p.y, p.z, p.w),
          .restated = p.w > 0 ? fmt::format("in front of the eye, at the distance {}", p.w)
                              : "at or behind the eye, or w is not a number",
          .expected = {ndc},
          .judge = [ndc](const Answer& answer) { return judge_point(ndc, answer); },
          .slipped = {{"opengl-depth", {opengl}}}};
}

// x and y, and how far they may be off. left + (x + 1) / 2 width rounds three times: the sum and
// the product by u |x + 1| / 2 width each, the result by u (|left| + |x + 1| / 2 width). With
// |x + 1| <= 2 max(1, |x|) that is at most u (|left| + 3 width max(1, |x|)); student.h allows 8 u.
Expected on_screen(const lab_04::ViewportCase& input, double x, double y) {
  const auto& [p, v] = input;
  return with_bounds(point("screen", {x, y}, 0, "px"),
                     {8 * kU * (std::abs(v.left) + v.width * std::max(1.0, std::abs(p.x))),
                      8 * kU * (std::abs(v.top) + v.height * std::max(1.0, std::abs(p.y)))});
}

Case expect_screen(const lab_04::ViewportCase& input) {
  const Point<Ndc, double>& p = input.p;
  const lab_04::Rectangle& v = input.viewport;
  const Rational half = Rational(1) / Rational(2);
  const Rational x = Rational(v.left) + (Rational(p.x) + Rational(1)) * half * Rational(v.width);
  const Rational y = Rational(v.top) + (Rational(1) - Rational(p.y)) * half * Rational(v.height);
  const auto expected = [&](double off) {
    return std::vector{on_screen(input, double(x) + off, double(y) + off),
                       numbers("depth", {p.z}, 0, "depth")};
  };
  const std::vector<Expected> right = expected(0);
  const auto judge = [right](const Answer& answer) {
    if (auto found = compare(right[0], answer).first) return found;
    return judge_point(right[1], answer);
  };
  return {.where = fmt::format("NDC ({}, {}, {})", p.x, p.y, p.z),
          .restated = fmt::format(
              "rectangle from ({}, {}), {} x {} pixels; y of NDC runs up, y of the screen down",
              v.left, v.top, v.width, v.height),
          .expected = right,
          .judge = judge,
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

// In z = n / (1 - d (1 - n/f)) (d: depth; n, f: near and far), the rounding of a number up to 1
// changes z by u z^2 / n (u: the unit roundoff), as long as z is below 2^49 n. At most four numbers
// up to 1 are rounded, and the quotient; 8 is more. From 2^49 n on, where that is more than z / 2,
// only a sum in which nothing cancels is good enough: its error is at most 4 u z at every distance.
// For f = infinity and d = 1 the result is exact.
double distance_bound(double z, double near) {
  return std::isinf(z) ? 0 : std::min(8 * kU * z * z / near, z / 2);
}

Case expect_depth(const lab_04::DepthCase& input) {
  const double z = exact_distance(input), near = input.near;
  const double bound = distance_bound(z, near);
  const auto expected = [](double value, double by) {
    return std::vector{numbers("distance", {value}, by, "world units")};
  };
  // The mistake of taking the depth for one in -1 .. 1, as in OpenGL, and mapping it to 0 .. 1
  // first.
  lab_04::DepthCase opengl = input;
  opengl.depth = (input.depth + 1) / 2;
  const double gl = exact_distance(opengl);
  return {.where = fmt::format("depth {}, near {}, far {}", input.depth, near, input.far),
          .restated =
              fmt::format("the distance is {}; one step of depth in float is {:.3g} of it there", z,
                          std::isinf(z) ? z : z / near * double(unit_roundoff<float>)),
          .expected = expected(z, bound),
          .slipped = {{"opengl-depth", expected(gl, 2 * distance_bound(gl, near))}}};
}

// ---- generated inputs ----

// A view, or that it is refused.
Case expect_view(const lab_04::Camera& camera) {
  const Expected refused = expect_refusals({camera}).expected[0];
  if (refused.values[0] == 0) {
    Case c = expect_camera(camera);
    c.expected.insert(c.expected.begin(), refused);
    c.slipped.clear();
    return c;
  }
  const auto& [fovy, aspect, near, far] = camera;
  return {.where = fmt::format("fovy {} radians, aspect {}", fovy, aspect),
          .restated = fmt::format("near {}, far {}; this view must be refused", near, far),
          .expected = {refused, matrix("clip_from_eye", 4, {})}};
}

bool right_view(const lab_04::Camera& camera, const Answer& answer) {
  const bool valid = perspective_of(camera).has_value();
  const auto* refused = find_field(answer, "refused");
  if (refused == nullptr || refused->size() != 1 || (*refused)[0] != (valid ? 0 : 1)) return false;
  if (!valid) return !judge_case(expect_view(camera), answer);
  // In double an entry has at most 5 roundings, of which the tangent's is up to 2 u.
  const double cot = 1 / std::tan(camera.fovy_radians / 2);
  const auto judged = judge_nearly(projection(view_of(cot, camera), kEntryRoundings), answer);
  return judged ? *judged : !judge_case(expect_view(camera), answer);
}

bool right_box(const lab_04::Box& box, const Answer& answer) {
  // In double an entry has three roundings.
  const auto judged = judge_nearly(projection(box_of<double>(box), kEntryRoundings), answer);
  return judged ? *judged : !judge_case(expect_box(box), answer);
}

bool right_dialect(const lab_04::DialectCase& input, const Answer& answer) {
  return has_field(answer, adapted(input, true));
}

bool right_divide(const Point<Clip, double>& p, const Answer& answer) {
  return !judge_point(ndc_of(p), answer);
}

bool right_screen(const lab_04::ViewportCase& input, const Answer& answer) {
  const auto& [p, v] = input;
  const auto* depth = find_field(answer, "depth");
  if (depth == nullptr || depth->size() != 1 || !same_bits((*depth)[0], p.z)) return false;
  const double x = v.left + (p.x + 1) / 2 * v.width, y = v.top + (1 - p.y) / 2 * v.height;
  const auto judged = judge_nearly(on_screen(input, x, y), answer);
  return judged ? *judged : !judge_case(expect_screen(input), answer);
}

bool right_depth(const lab_04::DepthCase& input, const Answer& answer) {
  // In double the distance is off by at most 4 u z, which is half of the bound or less: z >= near.
  const double z = input.near / ((1 - input.depth) + input.depth * (input.near / input.far));
  const double bound = distance_bound(z, input.near);
  const auto judged = judge_nearly({z}, bound, find_field(answer, "distance"));
  return judged ? *judged : !judge_case(expect_depth(input), answer);
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
       generated_check("any view", "4.1", "clip", generated_views, expect_view, right_view),
       hidden_check("views of extreme shape", "4.1", "clip", stiff_cameras, expect_camera),
       check("parallel views", "4.2", "clip", boxes, expect_box),
       generated_check("any box", "4.2", "clip", generated_boxes, expect_box, right_box),
       hidden_check("boxes far from the gaze", "4.2", "clip", more_boxes, expect_box),
       check("OpenGL's clip space", "4.3", "clip", projections<Dialect::kOpenGl>, expect_dialect),
       check("reversed depth", "4.3", "clip", projections<Dialect::kReversed>, expect_dialect),
       check("a left-handed eye", "4.3", "clip", projections<Dialect::kLeftHandedEye>,
             expect_dialect),
       generated_check("any projection in any dialect", "4.3", "clip", generated_matrices,
                       expect_dialect, right_dialect),
       check("points divided by w", "4.4", "NDC", points, expect_divide),
       generated_check("any point", "4.4", "NDC", generated_points, expect_divide, right_divide),
       hidden_check("more points divided by w", "4.4", "NDC", random_points, expect_divide),
       check("points on a picture of 640 x 480", "4.5", "screen", on_the_picture, expect_screen),
       generated_check("any point and rectangle", "4.5", "screen", generated_viewports,
                       expect_screen, right_screen),
       hidden_check("other rectangles of the screen", "4.5", "screen", viewports, expect_screen),
       check("distances from depths", "4.6", "depth", depths, expect_depth),
       generated_check("any depth", "4.6", "depth", generated_depths, expect_depth, right_depth),
       hidden_check("distances from depths close to 1", "4.6", "depth", stiff_depths,
                    expect_depth)}};
}

}  // namespace glassbox::labs
