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

constexpr double kU = unit_roundoff<double>;

// ---- 4.1 to 4.3: matrices ----

Expected matrix(const Transform<Clip, Eye>& m, double roundings) {
  Expected expected{"clip_from_eye", Shape::kMatrix, {}, 0, "", 4};
  double largest = 0;
  for (int i = 0; i < 16; ++i) {
    expected.values.push_back(m.at(i / 4, i % 4));
    largest = std::max(largest, std::abs(expected.values.back()));
  }
  expected.bound = roundings * kU * largest;
  return expected;
}

// Tangent, quotients and products round 4 or 5 times, on both sides; student.h allows 16.
constexpr double kEntryRoundings = 16;

std::vector<Case> camera_cases(const std::vector<lab_04::Camera>& cameras) {
  std::vector<Case> cases;
  for (const auto& [fovy, aspect, near, far] : cameras) {
    Case c;
    c.where = fmt::format("fovy {} radians, aspect {}", fovy, aspect);
    c.restated = fmt::format("near {}, far {}; the near plane's window is {:.6g} high", near, far,
                             2 * near * std::tan(fovy / 2));
    c.expected = {
        matrix(*perspective(fovy, aspect, {near, far, DepthRange::kStandard}), kEntryRoundings)};
    cases.push_back(c);
  }
  return cases;
}

std::vector<Case> refusal_cases() {
  std::vector<Case> cases;
  for (const auto& cameras : lab_04::refusals()) {
    Case c;
    c.where = fmt::format("{} views", cameras.size());
    Expected expected{"refused", Shape::kNumbers, {}, 0, "", 0};
    for (const auto& [fovy, aspect, near, far] : cameras) {
      const auto made = perspective(fovy, aspect, {near, far, DepthRange::kStandard});
      expected.values.push_back(made ? 0 : 1);
      c.restated +=
          fmt::format("{}number {}: fovy {}, aspect {}, near {}, far {}: {}",
                      c.restated.empty() ? "" : "\n", expected.values.size() - 1, fovy, aspect,
                      near, far, made ? "a view" : "refused, " + made.error().message());
    }
    c.expected = {expected};
    cases.push_back(c);
  }
  return cases;
}

std::vector<Case> box_cases(const std::vector<lab_04::Box>& boxes) {
  std::vector<Case> cases;
  for (const auto& [left, right, bottom, top, near, far] : boxes) {
    Case c;
    c.where = fmt::format("x {} .. {}, y {} .. {}", left, right, bottom, top);
    c.restated = fmt::format("near {}, far {}: eye z {} becomes 0, eye z {} becomes 1", near, far,
                             -near, -far);
    c.expected = {
        matrix(*orthographic({left, right, bottom, top}, {near, far, DepthRange::kStandard}),
               kEntryRoundings)};
    cases.push_back(c);
  }
  return cases;
}

// `before` acts on eye space, `after` on clip space; one of them is the identity.
std::vector<Case> dialect_cases(lab_04::Dialect dialect, const char* what) {
  std::vector<Case> cases;
  for (const lab_04::DialectCase& input : lab_04::in_clip_space(dialect)) {
    const auto adapted = [&](bool wrong_side) {
      glm::dmat4 adaptor(1);
      bool after = true;
      if (dialect == lab_04::Dialect::kOpenGl) adaptor = clip_gl_from_clip().columns;
      if (dialect == lab_04::Dialect::kReversed) adaptor = reverse_depth().columns;
      if (dialect == lab_04::Dialect::kLeftHandedEye) {
        adaptor = eye_left_from_eye().columns;
        after = false;
      }
      const glm::dmat4 product =
          after != wrong_side ? adaptor * input.m.columns : input.m.columns * adaptor;
      return matrix(Transform<Clip, Eye>(product), 4);
    };
    Case c;
    c.where = input.m.at(3, 3) == 0 ? "perspective, off centre" : "parallel";
    c.restated = what;
    c.expected = {adapted(false)};
    c.slipped = {{"multiplication-order", {adapted(true)}}};
    cases.push_back(c);
  }
  return cases;
}

// ---- 4.4 to 4.6: numbers ----

std::vector<Case> divide_cases(const std::vector<Point<Clip, double>>& points) {
  std::vector<Case> cases;
  for (const auto& p : points) {
    Case c;
    c.where = fmt::format("clip ({}, {}, {}, {})", p.x, p.y, p.z, p.w);
    c.restated = p.w > 0 ? fmt::format("in front of the eye, at the distance {}", p.w)
                         : "at the eye or behind it";
    Expected expected{"ndc", Shape::kPoint, {}, 0, "NDC", 0};
    double largest = 0;
    for (const double each : {p.x, p.y, p.z}) {
      if (!(p.w > 0)) continue;
      expected.values.push_back(double(Rational(each) / Rational(p.w)));
      largest = std::max(largest, std::abs(expected.values.back()));
    }
    expected.bound = p.w == 1 ? 0 : 4 * kU * largest;
    c.expected = {expected};
    cases.push_back(c);
  }
  return cases;
}

Case screen_case(const Point<Ndc, double>& p, const lab_04::Rectangle& v) {
  Case c;
  c.where = fmt::format("NDC ({}, {}, {})", p.x, p.y, p.z);
  c.restated =
      fmt::format("rectangle from ({}, {}), {} x {} pixels; y of NDC runs up, y of the screen down",
                  v.left, v.top, v.width, v.height);
  const Rational half = Rational(1) / Rational(2);
  const Rational x = Rational(v.left) + (Rational(p.x) + Rational(1)) * half * Rational(v.width);
  const Rational y = Rational(v.top) + (Rational(1) - Rational(p.y)) * half * Rational(v.height);
  const double bound = 8 * kU * std::max(std::abs(v.left) + v.width, std::abs(v.top) + v.height);
  c.expected = {{"screen", Shape::kPoint, {double(x), double(y)}, bound, "px", 0},
                {"depth", Shape::kNumbers, {p.z}, 0, "depth", 0}};
  return c;
}

std::vector<Case> screen_cases() {
  std::vector<Case> cases;
  for (const auto& p : lab_04::ndc_points()) cases.push_back(screen_case(p, lab_04::kPicture));
  return cases;
}

std::vector<Case> viewport_cases() {
  std::vector<Case> cases;
  for (const auto& [p, viewport] : lab_04::viewports()) cases.push_back(screen_case(p, viewport));
  return cases;
}

// z = n f / (f - d (f - n)); with an infinite far plane n / (1 - d).
double exact_distance(double depth, double near, double far) {
  const Rational d(depth), n(near);
  if (std::isinf(far)) return depth == 1 ? far : double(n / (Rational(1) - d));
  const Rational f(far);
  return double(n * f / (f - d * (f - n)));
}

std::vector<Case> depth_cases(const std::vector<lab_04::DepthCase>& inputs) {
  std::vector<Case> cases;
  for (const auto& [depth, near, far] : inputs) {
    Case c;
    c.where = fmt::format("depth {}, near {}, far {}", depth, near, far);
    const double z = exact_distance(depth, near, far);
    c.restated = fmt::format("the distance is {}; one step of depth in float is {:.3g} of it there",
                             z, std::isinf(z) ? z : z / near * double(unit_roundoff<float>));
    // Every rounding of a number up to 1 in z = n / (1 - d (1 - n/f)) moves z by u z^2 / n; there are four at most, and the
    // quotient's own. f = infinity, d = 1 is exact.
    c.expected = {{"distance",
                   Shape::kNumbers,
                   {z},
                   std::isinf(z) ? 0 : 8 * kU * z * z / near,
                   "world units",
                   0}};
    cases.push_back(c);
  }
  return cases;
}

}  // namespace

Lab lab_04() {
  Lab lab{4, "04-projection", "Projection, dialects, viewport", {}, {}};
  lab.tasks = {{"4.1", "Perspective", 25},  {"4.2", "Parallel projection", 15},
               {"4.3", "Dialects", 20},     {"4.4", "The divide", 15},
               {"4.5", "The viewport", 15}, {"4.6", "A distance from a depth", 10}};
  const auto add = [&](const char* name, const char* task, const char* stage, bool hidden,
                       auto cases) {
    lab.checks.push_back({name, task, stage, hidden, cases});
  };
  using lab_04::Dialect;
  add("perspective views", "4.1", "clip", false, [] { return camera_cases(lab_04::cameras()); });
  add("views that cannot be", "4.1", "clip", false, refusal_cases);
  add("views of extreme shape", "4.1", "clip", true,
      [] { return camera_cases(lab_04::stiff_cameras()); });
  add("parallel views", "4.2", "clip", false, [] { return box_cases(lab_04::boxes()); });
  add("boxes far from the gaze", "4.2", "clip", true,
      [] { return box_cases(lab_04::more_boxes()); });
  add("OpenGL's clip space", "4.3", "clip", false,
      [] { return dialect_cases(Dialect::kOpenGl, "z from 0 .. w to -w .. w"); });
  add("reversed depth", "4.3", "clip", false,
      [] { return dialect_cases(Dialect::kReversed, "z = 0 becomes z = w, and z = w becomes 0"); });
  add("a left-handed eye", "4.3", "clip", false, [] {
    return dialect_cases(Dialect::kLeftHandedEye,
                         "eye (x, y, z) is written (x, y, -z); the same clip point is expected");
  });
  add("points divided by w", "4.4", "NDC", false, [] { return divide_cases(lab_04::points()); });
  add("more points divided by w", "4.4", "NDC", true,
      [] { return divide_cases(lab_04::random_points()); });
  add("points on a picture of 640 x 480", "4.5", "screen", false, screen_cases);
  add("other rectangles of the screen", "4.5", "screen", true, viewport_cases);
  add("distances from depths", "4.6", "depth", false, [] { return depth_cases(lab_04::depths()); });
  add("distances from depths close to 1", "4.6", "depth", true,
      [] { return depth_cases(lab_04::stiff_depths()); });
  return lab;
}

}  // namespace glassbox::labs
