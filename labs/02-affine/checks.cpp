// The expected answers of lab 2, computed by the pipeline's own maps or in integers. A repaired
// rotation is judged by the properties of a rotation.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

#include "labs/02-affine/generators.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_02;
using Map = Transform<World, World>;

constexpr double u = unit_roundoff<double>;
// The factor by which the error bound grows for the mistake of taking degrees for radians: the
// angle is then 57.3 times as large, and so is its rounding error.
constexpr double kSlippedBound = 64;

// ---- about a point ----

// The 3 x 3 matrix of a map of the plane, taken from the 4 x 4 matrix that does the same in z = 0.
std::vector<double> entries_of_plane(const Map& m) {
  std::vector<double> all;
  for (const int i : {0, 1, 3}) {
    for (const int j : {0, 1, 3}) all.push_back(m.at(i, j));
  }
  return all;
}

// The pipeline takes no axis whose components are all subnormal, so the axis is scaled by a power
// of two first: its largest component is in [1/2, 1) then.
Map turn_degrees(const Vector<World, double>& axis, double degrees) {
  int exponent = 0;
  std::frexp(std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)}), &exponent);
  const Vector<World, double> scaled{std::ldexp(axis.x, -exponent), std::ldexp(axis.y, -exponent),
                                     std::ldexp(axis.z, -exponent)};
  return rotate_degrees<World>(scaled, degrees).value_or(Map{});
}

// The student's error, with u the unit roundoff: the angle in radians, up to 2 pi, has a relative
// error of 1.5 u. Sine and cosine have the error of the angle and one u of their own, at most
// 12 u together. The products and sums with the two translations at most double it, in the last
// column. The last row is exact.
Expected plane_map(const Map& m, const Point2& centre, double scale = 1) {
  const double turn = 24 * u * scale, last = turn * (1 + std::abs(centre.x) + std::abs(centre.y));
  return with_bounds(matrix("matrix", 3, entries_of_plane(m)),
                     {turn, turn, last, turn, turn, last, 0, 0, 0});
}

Map turn_about_centre(const Vector<World, double>& centre, double degrees) {
  return translate<World>(centre) * turn_degrees({0, 0, 1}, degrees) * translate<World>(-centre);
}

// The expected matrix is computed by the pipeline. Double is exact enough for it, because the
// pipeline takes the angle in degrees, in which it is not rounded.
Case expect_turn(const TurnCase& input) {
  const Vector<World, double> to(input.centre.x, input.centre.y, 0);
  const Vector<World, double> z_axis(0, 0, 1);
  const auto expected = [&](const Map& m, double scale) {
    return std::vector{plane_map(m, input.centre, scale)};
  };
  const auto& about = turn_about_centre;
  const double as_radians = degrees_from_radians(input.degrees);
  return {.where = fmt::format("about ({}, {}) by {} degrees", to.x, to.y, input.degrees),
          .restated = fmt::format("the point ({}, {}) stays where it is", to.x, to.y),
          .expected = expected(about(to, input.degrees), 1),
          .slipped = {{"multiplication-order", expected(about(-to, input.degrees), 1)},
                      {"translation-sign",
                       expected(translate<World>(to) * turn_degrees(z_axis, input.degrees) *
                                    translate<World>(to),
                                1)},
                      {"handedness", expected(about(to, -input.degrees), 1)},
                      {"half-angle", expected(about(to, input.degrees / 2), 1)},
                      {"degrees-radians", expected(about(to, as_radians), kSlippedBound)}}};
}

bool right_turn(const TurnCase& input, const Answer& answer) {
  const Map m = turn_about_centre({input.centre.x, input.centre.y, 0}, input.degrees);
  return has_field(answer, plane_map(m, input.centre));
}

// ---- steps ----

enum class Slip { kNone, kRadians, kClockwise, kHalfAngle, kBackwards, kAnyLength };

// Rodrigues' formula without making the axis 1 long first: a typical mistake.
Map turn_about_any_length(const Vector<World, double>& axis, double degrees) {
  const double a[3] = {axis.x, axis.y, axis.z};
  const double angle = radians_from_degrees(degrees), c = std::cos(angle), s = std::sin(angle);
  Map m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m.at(i, i) = a[i] * a[i] * (1 - c) + c;
    m.at(i, j) = a[i] * a[j] * (1 - c) - a[k] * s;
    m.at(j, i) = a[i] * a[j] * (1 - c) + a[k] * s;
  }
  return m;
}

Map matrix_of(const Step& step, Slip slip) {
  switch (step.kind) {
    case Step::Kind::kTranslate:
      return translate<World>(slip == Slip::kBackwards ? -step.v : step.v);
    case Step::Kind::kScale:
      return glassbox::scale<World>(step.v.x, step.v.y, step.v.z);
    case Step::Kind::kShear:
      return glassbox::shear<World>(Axis(step.changed), Axis(step.by), step.amount);
    case Step::Kind::kRotate:
      break;
  }
  if (slip == Slip::kAnyLength) return turn_about_any_length(step.v, step.amount);
  if (slip == Slip::kHalfAngle) return turn_degrees(step.v, step.amount / 2);
  if (slip == Slip::kRadians) return turn_degrees(step.v, degrees_from_radians(step.amount));
  return turn_degrees(step.v, slip == Slip::kClockwise ? -step.amount : step.amount);
}

double norm(const Map& m) {
  double largest = 0;
  for (int i = 0; i < 4; ++i) {
    double sum = 0;
    for (int j = 0; j < 4; ++j) sum += std::abs(m.at(i, j));
    largest = std::max(largest, sum);
  }
  return largest;
}

std::string step_text(const Step& step) {
  switch (step.kind) {
    case Step::Kind::kTranslate:
      return fmt::format("move by ({}, {}, {})", step.v.x, step.v.y, step.v.z);
    case Step::Kind::kRotate:
      return fmt::format("turn about ({}, {}, {}) by {} degrees", step.v.x, step.v.y, step.v.z,
                         step.amount);
    case Step::Kind::kScale:
      return fmt::format("scale by ({}, {}, {})", step.v.x, step.v.y, step.v.z);
    case Step::Kind::kShear:
      break;
  }
  return fmt::format("add {} {} to {}", step.amount, "xyz"[step.by], "xyz"[step.changed]);
}

// u is the unit roundoff. The entries of a rotation are off by 16 u (10 u from the angle; the rest
// from sine, cosine, axis and two operations), which is 48 u for a row of three. A product of
// matrices adds gamma(4), about 4 u, and the pipeline itself has 8 u. Together this is less than
// 64 u for each step, relative to the product of the norms.
double composition_bound(std::size_t steps, double norms) {
  return 64 * double(steps) * u * norms;
}

bool right_composition(const ComposeCase& input, const Answer& answer) {
  Map all;
  double norms = 1;
  for (const Step& step : input.steps) {
    const Map m = matrix_of(step, Slip::kNone);
    all = m * all;
    norms *= norm(m);
  }
  return has_numbers(answer, "world_from_object", entries(all),
                     composition_bound(input.steps.size(), norms));
}

Case expect_composition(const ComposeCase& input) {
  Map all, reversed;
  double norms = 1;
  std::string text;
  for (const Step& step : input.steps) {
    const Map m = matrix_of(step, Slip::kNone);
    all = m * all;
    reversed = reversed * m;
    norms *= norm(m);
    text += (text.empty() ? "" : ", then ") + step_text(step);
  }
  const double bound = composition_bound(input.steps.size(), norms);
  const auto expected = [&](const Map& m, double scale) {
    return std::vector{matrix("world_from_object", 4, entries(m), scale * bound)};
  };
  Case c{.where = input.what,
         .restated = text.empty() ? "nothing is done" : text,
         .expected = expected(all, 1),
         .slipped = {{"multiplication-order", expected(reversed, 1)}}};
  for (const auto& [name, slip] : {std::pair{"handedness", Slip::kClockwise},
                                   {"half-angle", Slip::kHalfAngle},
                                   {"translation-sign", Slip::kBackwards},
                                   {"degrees-radians", Slip::kRadians},
                                   {"not-normalised", Slip::kAnyLength}}) {
    Map slipped;
    double sizes = 1;
    for (const Step& step : input.steps) {
      const Map m = matrix_of(step, slip);
      slipped = m * slipped;
      sizes *= norm(m);
    }
    c.slipped.push_back({name, expected(slipped, kSlippedBound * std::max(1.0, sizes / norms))});
  }
  return c;
}

// ---- three points ----

std::string triangle_text(const std::array<Point2, 3>& p) {
  return fmt::format("({}, {}), ({}, {}), ({}, {})", p[0].x, p[0].y, p[1].x, p[1].y, p[2].x,
                     p[2].y);
}

// An integer type of 128 bits, which ISO C++ does not have.
__extension__ using Wide = __int128;

// The map that takes three points to three others, and the bounds of its errors.
struct Fit {
  std::vector<double> linear, last;  // the upper left 2 x 2 part, and the last column
  double bound = 0, last_bound = 0;
  double largest = 0;  // the largest entry of `linear` in size
};

// Computed in integers, where the linear part is num / det and the last column (target det - num
// source) / det, so that only the divisions round. Sizes stay below 2^21 for differences of
// coordinates, 2^43 for num and det, 2^65 for the last column. Returns nothing for three source
// points on a line.
std::optional<Fit> exact_fit(const FitCase& input) {
  const auto& s = input.source;
  const auto& t = input.target;
  const double ex = s[1].x - s[0].x, ey = s[1].y - s[0].y, fx = s[2].x - s[0].x,
               fy = s[2].y - s[0].y;
  const double det = ex * fy - fx * ey;
  if (det == 0) return std::nullopt;
  const double from[2] = {t[0].x, t[0].y};
  const double g[2] = {t[1].x - t[0].x, t[1].y - t[0].y};
  const double h[2] = {t[2].x - t[0].x, t[2].y - t[0].y};
  Fit fit;
  for (int i = 0; i < 2; ++i) {
    const double a = g[i] * fy - h[i] * ey, b = h[i] * ex - g[i] * fx;
    const Wide last = Wide(from[i]) * Wide(det) - Wide(a) * Wide(s[0].x) - Wide(b) * Wide(s[0].y);
    fit.linear.insert(fit.linear.end(), {a / det, b / det});
    fit.last.push_back(double(last) / det);
    fit.largest = std::max({fit.largest, std::abs(a / det), std::abs(b / det)});
  }
  const double size = std::max(std::abs(ex) + std::abs(ey), std::abs(fx) + std::abs(fy));
  const double inverse = std::max(std::abs(fy) + std::abs(ey), std::abs(fx) + std::abs(ex));
  const double condition = size * inverse / std::abs(det);
  // The linear part is G E^-1, where the columns of E and G are the edge vectors of the source and
  // the target. With c = `condition` and A = `largest`, |G| |E^-1| <= 2 c A. So the product has an
  // error of gamma(3) |G| |E^-1|, about 6 u c A (u: the unit roundoff); the determinant adds
  // 2 u c A, the other roundings 2 u A. Since c >= 1, 16 u c A is more than the sum.
  fit.bound = 16 * condition * u * fit.largest;
  fit.last_bound = fit.bound * (1 + std::abs(s[0].x) + std::abs(s[0].y)) +
                   4 * u * std::max(std::abs(from[0]), std::abs(from[1]));
  return fit;
}

// Any three points: there may be no map. The last row is exact.
Case expect_any_fit(const FitCase& input) {
  Case c{.where = input.what,
         .restated = "from " + triangle_text(input.source) + " to " + triangle_text(input.target) +
                     "; 1: there is a map, 0: std::nullopt"};
  const auto fit = exact_fit(input);
  c.expected = {numbers("there is a map", {fit ? 1.0 : 0.0})};
  if (!fit) return c;
  c.expected.push_back(matrix("linear part", 2, fit->linear, fit->bound));
  c.expected.push_back(numbers("last column", fit->last, fit->last_bound));
  c.expected.push_back(numbers("last row", {0, 0, 1}));
  return c;
}

bool right_fit(const FitCase& input, const Answer& answer) {
  const auto fit = exact_fit(input);
  if (!fit) return has_numbers(answer, "there is a map", {0}, 0);
  return has_numbers(answer, "there is a map", {1}, 0) &&
         has_numbers(answer, "linear part", fit->linear, fit->bound) &&
         has_numbers(answer, "last column", fit->last, fit->last_bound) &&
         has_numbers(answer, "last row", {0, 0, 1}, 0);
}

Case expect_fit(const FitCase& input) {
  const auto& s = input.source;
  const auto& t = input.target;
  const Fit fit = exact_fit(input).value_or(Fit{});  // the cases have no points on a line
  const double from[2] = {t[0].x, t[0].y};
  const std::vector<double> map{fit.linear[0],
                                fit.linear[1],
                                fit.last[0],
                                fit.linear[2],
                                fit.linear[3],
                                fit.last[1],
                                0,
                                0,
                                1};
  const auto expected = [&](const std::vector<double>& m, double scale) {
    return std::vector{matrix("linear part", 2, {m[0], m[1], m[3], m[4]}, scale * fit.bound),
                       matrix("map", 3, m, scale * fit.last_bound)};
  };
  std::vector<double> backwards = map;
  backwards[2] = -map[2];
  backwards[5] = -map[5];
  // The map with the typical mistake E^-1 G instead of G E^-1 (E, G: the edge vectors of source and
  // target as columns), and the last column that belongs to it.
  const double ex = s[1].x - s[0].x, ey = s[1].y - s[0].y, fx = s[2].x - s[0].x,
               fy = s[2].y - s[0].y;
  const double gx = t[1].x - t[0].x, gy = t[1].y - t[0].y, hx = t[2].x - t[0].x,
               hy = t[2].y - t[0].y;
  const double det = ex * fy - fx * ey;
  std::vector<double> other{(fy * gx - fx * gy) / det,
                            (fy * hx - fx * hy) / det,
                            0,
                            (ex * gy - ey * gx) / det,
                            (ex * hy - ey * hx) / det,
                            0,
                            0,
                            0,
                            1};
  double growth = 1;
  for (const std::size_t row : {0u, 3u}) {
    other[row + 2] = from[row / 3] - (other[row] * s[0].x + other[row + 1] * s[0].y);
    growth = std::max(
        {growth, std::abs(other[row]) / fit.largest, std::abs(other[row + 1]) / fit.largest});
  }
  return {.where = input.what,
          .restated = "from " + triangle_text(s) + " to " + triangle_text(t),
          .expected = expected(map, 1),
          .slipped = {{"translation-sign", expected(backwards, 1)},
                      {"multiplication-order", expected(other, growth)}}};
}

Case expect_line(const LineCase& input) {
  return {input.what,
          "on a line: " + triangle_text(input.on_a_line) +
              "; not on a line: " + triangle_text(input.off_it) + "; 1: a map, 0: std::nullopt",
          {numbers("on a line", {0}), numbers("not on a line", {1})}};
}

// ---- axis and angle ----

struct Turn {
  std::vector<double> axis{0, 0, 1};
  double angle = 0;
};

// For the quaternion (w; x, y, z) the axis is (x, y, z) / |(x, y, z)| and the angle is
// 2 atan2(|(x, y, z)|, w).
Turn turn_of(const RotationCase& q) {
  const double x = q.x, y = q.y, z = q.z;
  const double sine = std::sqrt(x * x + y * y + z * z);
  Turn turn;
  turn.angle = 2 * arctan2(sine, q.w);
  if (sine > 0) turn.axis = {x / sine, y / sine, z / sine};
  const auto first =
      std::find_if(turn.axis.begin(), turn.axis.end(), [](double each) { return each != 0; });
  if (q.w == 0 && *first < 0) {
    for (double& each : turn.axis) each = -each;
  }
  return turn;
}

// The entries of R have relative errors of u (the unit roundoff). Up to a right angle the axis
// comes from R - R^T, whose entries are as small as the angle; beyond it from the longest column
// of (R + R^T)/2 - cos I, whose length is at least 1/3. In both cases the axis is off by a few u,
// and so are sine, cosine and the angle: by 16 u at most. The bound is twice that, for the errors
// of the student's answer and of ours.
constexpr double kAxisBound = 32 * u;  // and the bound of the angle's relative error

bool right_axis(const RotationCase& q, const Answer& answer) {
  const Turn turn = turn_of(q);
  return has_numbers(answer, "axis", turn.axis, kAxisBound) &&
         has_numbers(answer, "angle", {turn.angle}, kAxisBound * turn.angle);
}

Case expect_axis(const RotationCase& q) {
  const auto [axis, angle] = turn_of(q);
  const Expected the_axis = point("axis", axis, kAxisBound);
  const Expected the_angle = numbers("angle", {angle}, kAxisBound * angle, "radian");
  Expected opposite = the_axis, as_it_is = the_axis;
  for (double& each : opposite.values) each = -each;
  for (double& each : as_it_is.values) each *= std::sin(angle);
  Case c{.where = q.what,
         .restated =
             fmt::format("the quaternion ({}; {}, {}, {}) scaled to length 1", q.w, q.x, q.y, q.z),
         .expected = {the_axis, the_angle},
         .slipped = {{"row-column-order", {opposite, the_angle}}}};
  // The mistake of not normalising the axis: it comes from (R - R^T)/2 and has the angle's sine as
  // its length.
  if (angle > 0 && q.w != 0) c.slipped.push_back({"not-normalised", {as_it_is, the_angle}});
  return c;
}

// ---- rotations again: any that is near enough is right ----

std::optional<Divergence> judge_rotation(const Map& given, const Answer& answer) {
  Divergence found;
  found.field = "rotation";
  const auto* values = find_field(answer, "rotation");
  if (values == nullptr || values->size() != 16) {
    found.kind = Divergence::Kind::kMissing;
    found.explanation = "16 numbers are expected";
    return found;
  }
  glm::dmat3 before(given.columns), after;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) after[j][i] = (*values)[std::size_t(4 * i + j)];
  }
  // R is the student's answer, `after`. If its columns were made 1 long, their components are off
  // by 3 u (u: the unit roundoff), so an entry of R^T R is off by 6 u from its factors and by 3 u
  // from the rounding of its sum: 9 u and terms of second order, which is less than 16 u.
  const double drift = orthogonality_error(before), error = orthogonality_error(after);
  found.actual = found.distance = error;
  found.bound = 16 * u;
  if (std::isnan(error)) found.kind = Divergence::Kind::kNotANumber;
  if (!(error <= found.bound)) {
    found.element = "largest entry of |R^T R - I|";
    found.explanation = fmt::format("this entry was {:.3g} before the repair", drift);
    return found;
  }
  if (!(glm::determinant(after) > 0)) {
    found.element = "determinant";
    found.expected = 1;
    found.actual = glm::determinant(after);
    found.distance = 2;
    found.bound = 0;
    found.explanation = "the result is a mirror, not a rotation";
    return found;
  }
  found.bound = 3 * drift + 16 * u;
  for (std::size_t n = 0; n < 16; ++n) {
    const int i = int(n) / 4, j = int(n) % 4;
    const bool border = i == 3 || j == 3;
    found.index = n;
    found.element = fmt::format("row {}, column {}", i, j);
    found.expected = given.at(i, j);
    found.actual = (*values)[n];
    found.distance = std::abs(found.actual - found.expected);
    if (border) found.bound = 0;
    if (!(found.distance <= found.bound)) {
      found.explanation = border ? "the last row and column must be those of the identity"
                                 : "this is a rotation, but it is too far from the given matrix";
      return found;
    }
    found.bound = 3 * drift + 16 * u;
  }
  return std::nullopt;
}

Case expect_repair(const DriftCase& input) {
  const Map given = input.matrix;
  return {.where = input.what,
          .restated = fmt::format("the largest entry of |R^T R - I| is {:.3g}",
                                  orthogonality_error(glm::dmat3(given.columns))),
          .expected = {matrix("rotation", 4, entries(given))},
          .judge = [given](const Answer& answer) { return judge_rotation(given, answer); }};
}

}  // namespace

Lab lab_02() {
  return {2,
          "02-affine",
          "Affine maps: composition, correspondences, rotations",
          {{"2.1", "Turn the plane about a point", 15},
           {"2.2", "Compose translations, rotations, scalings and shears", 25},
           {"2.3", "Fit an affine map to three pairs of points", 20},
           {"2.4", "Find the axis and the angle of a rotation", 25},
           {"2.5", "Repair a rotation that has drifted", 15}},
          {check("the plane turns about a point", "2.1", "world", turns, expect_turn),
           generated_check("any turn", "2.1", "world", generated_turns, expect_turn, right_turn),
           hidden_check("other points and angles", "2.1", "world", hidden_turns, expect_turn),
           check("one step", "2.2", "world", single_steps, expect_composition),
           check("steps one after the other", "2.2", "world", compositions, expect_composition),
           generated_check("any steps", "2.2", "world", generated_compositions, expect_composition,
                           right_composition),
           hidden_check("mirrors, shears and deep hierarchies", "2.2", "world", hidden_compositions,
                        expect_composition),
           check("three points determine a map", "2.3", "world", fits, expect_fit),
           check("three points on a line do not", "2.3", "world", lines, expect_line),
           generated_check("any three points", "2.3", "world", generated_fits, expect_any_fit,
                           right_fit),
           hidden_check("needles and flat targets", "2.3", "world", hidden_fits, expect_fit),
           check("axis and angle", "2.4", "world", rotations, expect_axis),
           check("axis and angle near no turn and half a turn", "2.4", "world", stiff_rotations,
                 expect_axis),
           generated_check("any rotation", "2.4", "world", generated_rotations, expect_axis,
                           right_axis),
           hidden_check("other axes and angles", "2.4", "world", hidden_rotations, expect_axis),
           check("what has drifted is a rotation again", "2.5", "world", drifts, expect_repair),
           generated_check("any drift", "2.5", "world", generated_drifts, expect_repair),
           hidden_check("other drifts", "2.5", "world", hidden_drifts, expect_repair)}};
}

}  // namespace glassbox::labs
