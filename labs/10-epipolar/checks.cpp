// The expected answers of lab 10, from the functions of views/two_view and from formulas in
// extended precision (long double).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>

#include "labs/10-epipolar/cases.h"
#include "labs/10-epipolar/reference.h"
#include "labs/framework/lab.h"
#include "views/two_view/constraint.h"
#include "views/two_view/pose.h"

namespace glassbox::labs {

namespace {

using namespace lab_10;
using epipolar::entries_of;
using epipolar::matches_of;
using epipolar::matrix_of;
using epipolar::pose_of;
using epipolar::vector_of;
using lab_10::Matrix;
using lab_10::Vector;

constexpr double u = unit_roundoff<double>;

// A matrix in extended precision: expected answers are computed in it and then rounded once.
using Wide = Eigen::Matrix<long double, 3, 3>;
using WideVector = Eigen::Matrix<long double, 3, 1>;
Wide wide(const Matrix& m) {
  return matrix_of(m).cast<long double>();
}
WideVector wide(const Vector& v) {
  return vector_of(v).cast<long double>();
}
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

Case expect_line(const LineCase& input) {
  const auto& [what, e, left, right, pixel] = input;
  const auto expected = [&left = left, &right = right, &pixel = pixel](const Matrix& m) {
    const Line l = epipolar::line_of(m, left, right, pixel);
    const double bound = epipolar::bound_of_line(m, left, right, pixel);
    return std::vector{numbers("a, b", {l.a, l.b}, bound), numbers("c", {l.c}, bound, "px")};
  };
  return {.where = what,
          .restated = fmt::format(
              "E has the rows {}\nleft camera: f {}, principal point ({}, {}); right one: f {}, "
              "({}, {}); left pixel ({}, {})",
              text_of(e), left.f, left.x, left.y, right.f, right.x, right.y, pixel.x, pixel.y),
          .expected = expected(e),
          .slipped = {{"row-column-order", expected(transposed(e))}}};
}

// The bounds: the sum of n numbers rounds n - 1 times, each time by u of the sum so far. The scale
// is computed from the distances to the centre, and so it also has the error of the centre.
Case expect_normaliser(const PointsCase& input) {
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
  return {input.what,
          fmt::format("{} points, the first ({}, {})", input.points.size(), input.points[0].x,
                      input.points[0].y),
          {numbers("centre", {double(x), double(y)}, 8 * count * u * largest),
           numbers("scale", {scale}, 16 * count * u * scale * (1 + scale * largest))}};
}

Case expect_matrix_of_matches(const MatchesCase& input) {
  const auto solution = epipolar::solve(matches_of(input.matches));
  const auto expected = [&](const views::Matrix3d& m) {
    return std::vector{matrix("E", 3, entries_of(m), solution.bound)};
  };
  std::string text = fmt::format(
      "{} matches; the system's condition is {:.3g}. E is compared at |E| = 1, with its largest "
      "entry positive. The cameras have R with the rows {} and T = {}",
      input.matches.size(), solution.condition, text_of(input.pose.rotation),
      text_of(input.pose.translation));
  for (std::size_t i = 0; i < std::min<std::size_t>(input.matches.size(), 3); ++i) {
    const Match& m = input.matches[i];
    text += fmt::format("\nmatch {}: left ({:.9g}, {:.9g}), right ({:.9g}, {:.9g})", i, m.left.x,
                        m.left.y, m.right.x, m.right.y);
  }
  return {.where = input.what,
          .restated = text,
          .expected = expected(solution.essential),
          .slipped = {{"not-denormalised", expected(solution.not_carried_back)},
                      {"rank-first", expected(solution.made_rank_two_first)}}};
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

Case expect_point(const RaysCase& input) {
  const views::Rays rays{{input.left.x, input.left.y, 1}, {input.right.x, input.right.y, 1}};
  const views::RelativePose pose = pose_of(input.pose);
  const views::Triangulated found = epipolar::point_of(rays, pose);
  const double bound = epipolar::bound_of_point(rays, pose, found);
  const auto& p = found.point;
  return {input.what,
          fmt::format("left ({}, {}), right ({}, {}), R has the rows {}, T = {}; the lines pass "
                      "each other at {:.3g}",
                      input.left.x, input.left.y, input.right.x, input.right.y,
                      text_of(input.pose.rotation), text_of(input.pose.translation), found.gap) +
              extreme_case_command(input.what),
          {point("point", {p[0], p[1], p[2], p[3]}, bound, "world units")}};
}

}  // namespace

Lab lab_10() {
  return {10,
          "10-epipolar",
          "Two pictures: epipolar geometry and triangulation",
          {{"10.1", "The matrix of two cameras", 20},
           {"10.2", "The line on which the other point lies", 15},
           {"10.3", "Points of the size that suits", 10},
           {"10.4", "The matrix of eight matches and more", 25},
           {"10.5", "One pose of four", 15},
           {"10.6", "Where lines of sight meet", 15}},
          {check("the matrix of two cameras", "10.1", "eye", poses, expect_matrix),
           check("the centre of a camera from its shift", "10.1", "eye", poses, expect_centre),
           hidden_check("other cameras", "10.1", "eye", hidden_poses, expect_matrix),
           hidden_check("other shifts", "10.1", "eye", hidden_poses, expect_centre),
           check("the line on which the other point lies", "10.2", "screen", lines, expect_line),
           hidden_check("other lines", "10.2", "screen", hidden_lines, expect_line),
           check("points of the size that suits", "10.3", "eye", points, expect_normaliser),
           hidden_check("other points of the size that suits", "10.3", "eye", hidden_points,
                        expect_normaliser),
           check("the matrix of eight matches and more", "10.4", "eye", matches,
                 expect_matrix_of_matches),
           hidden_check("other matches", "10.4", "eye", hidden_matches, expect_matrix_of_matches),
           check("one pose of four", "10.5", "eye", choices, expect_pose),
           hidden_check("other poses", "10.5", "eye", hidden_choices, expect_pose),
           check("where lines of sight meet", "10.6", "eye", rays, expect_point),
           hidden_check("other lines of sight", "10.6", "eye", hidden_rays, expect_point)}};
}

}  // namespace glassbox::labs
