// The expected answers of lab 10, from the functions of views/two_view and from formulas in
// extended precision (long double).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>

#include "labs/10-epipolar/generators.h"
#include "labs/10-epipolar/reference.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"
#include "views/two_view/constraint.h"
#include "views/two_view/pose.h"

namespace glassbox::labs {

namespace {

using namespace lab_10;
using epipolar::entries_of;
using epipolar::matches_of;
using epipolar::matrix_of;
using epipolar::vector_of;
using epipolar::Wide;
using epipolar::wide;
using epipolar::WideVector;
using lab_10::Matrix;
using lab_10::Vector;

constexpr double u = unit_roundoff<double>;

std::vector<double> rounded(const Wide& m) {
  return entries_of(m.cast<double>());
}
std::vector<double> rounded(const WideVector& v) {
  return {double(v[0]), double(v[1]), double(v[2])};
}

std::string text_of(const Vector& v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v[0], v[1], v[2]);
}
std::string text_of(const Matrix& m) {
  return text_of(m[0]) + " " + text_of(m[1]) + " " + text_of(m[2]);
}

// The bound: an entry of E is the difference of two products of an entry of R and one of T, with an
// error below 3 u |T|, where u = 2^-53 is the unit roundoff.
Case expect_matrix(const PoseCase& input) {
  const Wide r = wide(input.pose.rotation);
  const WideVector t = wide(input.pose.translation);
  const Wide e = views::essential<long double>(r, t);
  const double bound = 4 * u * vector_of(input.pose.translation).norm();
  const auto expected = [&](const Wide& m) {
    return std::vector{matrix("E", 3, rounded(m), bound)};
  };
  return {.where = input.what,
          .restated = fmt::format("R has the rows {}; T = {}", text_of(input.pose.rotation),
                                  text_of(input.pose.translation)),
          .expected = expected(e),
          .slipped = {{"cross-order", expected(-e)},
                      {"multiplication-order", expected(views::cross_matrix<long double>(t) * r)}}};
}

// The bound: a coordinate of T is the dot product of t and a column of R, which is a unit vector.
// Its three products and their sum round by less than the allowed 8 u |t|.
Case expect_centre(const PoseCase& input) {
  const Wide r = wide(input.pose.rotation);
  const WideVector t = wide(input.pose.translation);
  const double bound = 8 * u * vector_of(input.pose.translation).norm();
  const auto expected = [&](const WideVector& v) {
    return std::vector{point("T", rounded(v), bound, "world units")};
  };
  return {.where = input.what,
          .restated = fmt::format("R has the rows {}; t = {}", text_of(input.pose.rotation),
                                  text_of(input.pose.translation)),
          .expected = expected(-(r.transpose() * t)),
          .slipped = {{"shift-for-centre", expected(t)},
                      {"translation-sign", expected(r.transpose() * t)},
                      {"row-column-order", expected(-(r * t))}}};
}

// The judge of a case in which more than one answer is right. `explanation` is for a wrong answer
// that is not far from the expected one.
std::function<std::optional<Divergence>(const Answer&)> judged_by(
    const std::vector<Expected>& expected, std::function<bool(const Answer&)> is_right,
    const char* explanation) {
  return [expected, is_right, explanation](const Answer& answer) -> std::optional<Divergence> {
    if (is_right(answer)) return std::nullopt;
    for (const Expected& e : expected) {
      if (auto first = compare(e, answer).first) return first;
    }
    return Divergence{.field = expected[0].field, .explanation = explanation};
  };
}

// Which answers are right where rounding decides about the sign of the line, or whether there is
// one.
bool has_right_sign(double a, double b) {
  return b > 0 || (b == 0 && a > 0);
}
bool right_line(const LineCase& input, const Answer& answer) {
  const auto& [what, e, left, right, pixel] = input;
  const epipolar::ExactLine exact = epipolar::exact_line_of(e, left, right, pixel);
  const auto *ab = find_field(answer, "a, b"), *only_c = find_field(answer, "c");
  if (ab == nullptr || ab->size() != 2 || only_c == nullptr || only_c->size() != 1) return false;
  const double a = (*ab)[0], b = (*ab)[1], c = (*only_c)[0];
  const bool none = a == 0 && b == 0 && c == 0;
  if (exact.across == 0) return none;
  if (exact.across <= 8 * u * exact.size)
    return none ||
           (has_right_sign(a, b) && std::abs(a * a + b * b - 1) <= 16 * u && std::isfinite(c));
  if (!has_right_sign(a, b)) return false;
  const auto near = [&](double sign) {
    const Line& l = exact.line;
    return std::abs(a - sign * l.a) <= exact.bound_of_ab &&
           std::abs(b - sign * l.b) <= exact.bound_of_ab &&
           std::abs(c - sign * l.c) <= exact.bound_of_c;
  };
  // Where b is 0 except for its error, its sign is that of the error.
  return near(1) || (std::abs(exact.line.b) <= exact.bound_of_ab && near(-1));
}

Case expect_line(const LineCase& input) {
  const auto& [what, e, left, right, pixel] = input;
  const auto expected = [&left = left, &right = right, &pixel = pixel](const Matrix& m) {
    const epipolar::ExactLine exact = epipolar::exact_line_of(m, left, right, pixel);
    const Line& l = exact.line;
    return std::vector{numbers("a, b", {l.a, l.b}, exact.bound_of_ab),
                       numbers("c", {l.c}, exact.bound_of_c, "px")};
  };
  const epipolar::ExactLine exact = epipolar::exact_line_of(e, left, right, pixel);
  Case made{.where = what,
            .restated = fmt::format(
                "E has the rows {}\nleft camera: f {}, principal point ({}, {}); right one: f {}, "
                "({}, {}); left pixel ({}, {})",
                text_of(e), left.f, left.x, left.y, right.f, right.x, right.y, pixel.x, pixel.y),
            .expected = expected(e),
            .slipped = {{"row-column-order", expected(transposed(e))}}};
  if (exact.across > 0 && std::abs(exact.line.b) <= exact.bound_of_ab)
    made.judge = judged_by(
        made.expected, [input](const Answer& answer) { return right_line(input, answer); },
        "the sign or the length is not as the contract says");
  return made;
}

// The bounds: the sum of n numbers rounds n - 1 times, each time by u of the sum so far. The scale
// is computed from the distances to the centre, and so it also has the error of the centre.
std::vector<Expected> expected_normaliser(const PointsCase& input) {
  const auto count = double(input.points.size());
  long double x = 0, y = 0, sum = 0;
  double largest = 0;
  for (const Pixel& p : input.points) {
    x += p.x;
    y += p.y;
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  x /= count;
  y /= count;
  for (const Pixel& p : input.points) sum += std::hypot(p.x - x, p.y - y);
  const double scale = double(std::sqrt(2.0L) * count / sum);
  return {numbers("centre", {double(x), double(y)}, 8 * count * u * largest),
          numbers("scale", {scale}, 16 * count * u * scale * (1 + scale * largest))};
}
Case expect_normaliser(const PointsCase& input) {
  return {input.what,
          fmt::format("{} points, the first ({}, {})", input.points.size(), input.points[0].x,
                      input.points[0].y),
          expected_normaliser(input)};
}
bool right_normaliser(const PointsCase& input, const Answer& answer) {
  return has_fields(answer, expected_normaliser(input));
}

// Whether two entries of different signs are the largest ones to within the bound, so that rounding
// decides which of them is made positive.
bool has_two_largest(const views::Matrix3d& m, double bound) {
  return -m.minCoeff() >= m.maxCoeff() - 2 * bound;
}

Case expect_matrix_of_matches(const MatchesCase& input) {
  const auto solution = epipolar::solve(matches_of(input.matches));
  const auto expected = [&](const views::Matrix3d& m) {
    return std::vector{matrix("E", 3, entries_of(m), solution.bound)};
  };
  std::string text = fmt::format(
      "{} matches; the system's condition is {:.3g}. E is compared at |E| = 1, with its largest "
      "entry positive",
      input.matches.size(), solution.condition);
  // Generated matches are not made from a pose.
  if (determinant(input.pose.rotation) != 0)
    text += fmt::format(". The cameras have R with the rows {} and T = {}",
                        text_of(input.pose.rotation), text_of(input.pose.translation));
  for (std::size_t i = 0; i < std::min<std::size_t>(input.matches.size(), 3); ++i) {
    const Match& m = input.matches[i];
    text += fmt::format("\nmatch {}: left ({:.9g}, {:.9g}), right ({:.9g}, {:.9g})", i, m.left.x,
                        m.left.y, m.right.x, m.right.y);
  }
  Case made{.where = input.what,
            .restated = text,
            .expected = expected(solution.essential),
            .slipped = {{"not-denormalised", expected(solution.not_carried_back)},
                        {"rank-first", expected(solution.made_rank_two_first)}}};
  if (has_two_largest(solution.essential, solution.bound)) {
    made.judge = judged_by(
        made.expected,
        [made, negated = expected(-solution.essential)](const Answer& answer) {
          return has_fields(answer, made.expected) || has_fields(answer, negated);
        },
        "this is E neither with the one sign nor with the other");
  }
  return made;
}

// The bound: the given E is R S except for rounding, and so its singular vectors U and V have
// rounding errors, too. The student multiplies U, V and a rotation to get R.
Case expect_pose(const ChoiceCase& input) {
  const auto chosen = views::pose_in_front(matrix_of(input.essential), matches_of(input.matches));
  const views::RelativePose pose = chosen ? chosen->pose : views::RelativePose{};
  return {input.what,
          fmt::format("E has the rows {}; {} matches; with this pose, {} of them are in front of "
                      "both cameras, and with any other pose at most {} (C-105)",
                      text_of(input.essential), input.matches.size(), chosen ? chosen->in_front : 0,
                      chosen ? chosen->runner_up : 0) +
              extreme_case_command("C-105"),
          {matrix("R", 3, entries_of(pose.rotation), epipolar::kPoseBound),
           point("T", {pose.translation[0], pose.translation[1], pose.translation[2]},
                 epipolar::kPoseBound)}};
}

std::vector<Expected> expected_point(const epipolar::ExactPoint& exact) {
  const Vector& p = exact.place;
  return {point("point", {p[0], p[1], p[2]}, exact.bound, "world units"), numbers("w", {exact.w})};
}

// Whether the answer is right where rounding decides if the lines are parallel.
bool right_between(const RaysCase& input, const epipolar::ExactPoint& exact, const Answer& answer) {
  const auto *place = find_field(answer, "point"), *w = find_field(answer, "w");
  if (place == nullptr || place->size() != 3 || w == nullptr || w->size() != 1) return false;
  if ((*w)[0] == 0) return *place == std::vector<double>{input.left.x, input.left.y, 1};
  // A point for which the lines count as parallel has no bound, as there is no place that is meant.
  if (exact.w == 1) return has_fields(answer, expected_point(exact));
  return (*w)[0] == 1 && std::isfinite((*place)[0] + (*place)[1] + (*place)[2]);
}

bool right_point(const RaysCase& input, const Answer& answer) {
  const auto exact = epipolar::exact_point_of(input.left, input.right, input.pose);
  return epipolar::is_between(exact) ? right_between(input, exact, answer)
                                     : has_fields(answer, expected_point(exact));
}

Case expect_point(const RaysCase& input) {
  const auto exact = epipolar::exact_point_of(input.left, input.right, input.pose);
  Case made{input.what,
            fmt::format("left ({}, {}), right ({}, {}), R has the rows {}, T = {}; the sine of the "
                        "angle between the lines is {:.3g}, and they pass each other at {:.3g}",
                        input.left.x, input.left.y, input.right.x, input.right.y,
                        text_of(input.pose.rotation), text_of(input.pose.translation),
                        double(exact.sine), exact.gap) +
                extreme_case_command(input.what),
            expected_point(exact)};
  if (epipolar::is_between(exact))
    made.judge = judged_by(
        made.expected, [input](const Answer& answer) { return right_point(input, answer); },
        "this is neither the direction d with w = 0 nor a point with w = 1");
  return made;
}

bool right_matrix(const PoseCase& input, const Answer& answer) {
  const Wide e =
      views::essential<long double>(wide(input.pose.rotation), wide(input.pose.translation));
  const double bound = 4 * u * vector_of(input.pose.translation).norm();
  return has_fields(answer, {matrix("E", 3, rounded(e), bound)});
}
bool right_centre(const PoseCase& input, const Answer& answer) {
  const WideVector t = -(wide(input.pose.rotation).transpose() * wide(input.pose.translation));
  const double bound = 8 * u * vector_of(input.pose.translation).norm();
  return has_fields(answer, {point("T", rounded(t), bound, "world units")});
}

}  // namespace

Lab lab_10() {
  return {
      10,
      "10-epipolar",
      "Two pictures: epipolar geometry and triangulation",
      {{"10.1", "The matrix of two cameras", 20},
       {"10.2", "The line on which the other point lies", 15},
       {"10.3", "Points of the size that suits", 10},
       {"10.4", "The matrix of eight matches and more", 25},
       {"10.5", "One pose of four", 15},
       {"10.6", "Where lines of sight meet", 15}},
      {check("the matrix of two cameras", "10.1", "eye", poses, expect_matrix),
       generated_check("the matrix of any two cameras", "10.1", "eye", generated_poses,
                       expect_matrix, right_matrix),
       check("the centre of a camera from its shift", "10.1", "eye", poses, expect_centre),
       generated_check("any shift", "10.1", "eye", generated_poses, expect_centre, right_centre),
       hidden_check("other cameras", "10.1", "eye", hidden_poses, expect_matrix),
       hidden_check("other shifts", "10.1", "eye", hidden_poses, expect_centre),
       check("the line on which the other point lies", "10.2", "screen", lines, expect_line),
       generated_check("any line", "10.2", "screen", generated_lines, expect_line, right_line),
       hidden_check("other lines", "10.2", "screen", hidden_lines, expect_line),
       check("points of the size that suits", "10.3", "eye", points, expect_normaliser),
       generated_check("any points", "10.3", "eye", generated_points, expect_normaliser,
                       right_normaliser),
       hidden_check("other points of the size that suits", "10.3", "eye", hidden_points,
                    expect_normaliser),
       check("the matrix of eight matches and more", "10.4", "eye", matches,
             expect_matrix_of_matches),
       generated_check("any matches", "10.4", "eye", generated_matches, expect_matrix_of_matches),
       hidden_check("other matches", "10.4", "eye", hidden_matches, expect_matrix_of_matches),
       check("one pose of four", "10.5", "eye", choices, expect_pose),
       generated_check("any pose of four", "10.5", "eye", generated_choices, expect_pose),
       hidden_check("other poses", "10.5", "eye", hidden_choices, expect_pose),
       check("where lines of sight meet", "10.6", "eye", rays, expect_point),
       generated_check("any lines of sight", "10.6", "eye", generated_rays, expect_point,
                       right_point),
       hidden_check("other lines of sight", "10.6", "eye", hidden_rays, expect_point)}};
}

}  // namespace glassbox::labs
