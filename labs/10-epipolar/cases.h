// The inputs of lab 10's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_10 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

// The rotation of the quaternion (w, x, y, z), which may have any length.
inline Matrix turned_by(double w, double x, double y, double z) {
  const double n = w * w + x * x + y * y + z * z;
  return {
      {{(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n},
       {2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n},
       {2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n}}};
}
inline Matrix not_turned() {
  return turned_by(1, 0, 0, 0);
}

// The three pairs of cameras of the slides: with parallel axes, with converging axes, and any two.
inline Pose parallel_pose() {
  return {not_turned(), {0.5, 0, 0}};
}
inline Pose converging_pose() {
  return {turned_by(15, 0, 1, 0), {1, 0, 0.125}};  // both cameras look at a point about 8 away
}
inline Pose arbitrary_pose() {
  return {turned_by(12, 1, -2, 1.5), {0.8, -0.3, 0.4}};
}
inline Pose random_pose(glassbox::Random& random) {
  const double x = random.between(-0.15, 0.15), y = random.between(-0.15, 0.15);
  const Matrix rotation = turned_by(1, x, y, random.between(-0.15, 0.15));
  const double right = random.between(0.4, 1), down = random.between(-0.4, 0.4);
  return {rotation, {right, down, random.between(-0.4, 0.4)}};
}

// ---- essential matrices (task 10.1) ----

struct PoseCase {
  const char* what;
  Pose pose;
};
inline std::vector<PoseCase> poses() {
  return {{"parallel axes", parallel_pose()},
          {"converging axes", converging_pose()},
          {"any two cameras", arbitrary_pose()}};
}
// BEGIN HIDDEN
inline std::vector<PoseCase> hidden_poses() {
  return glassbox::labs::with_varied(
      std::vector<PoseCase>{{"one camera in front of the other", {not_turned(), {0, 0, 2}}},
                            {"a quarter turn", {turned_by(1, 0, 0, 1), {0.3, 0.7, -1.1}}},
                            {"both cameras in one place", {turned_by(9, 1, 2, -1), {0, 0, 0}}},
                            {"far apart", {turned_by(3, -1, 2, 1), {700, -300, 90}}}},
      101, 3, [](glassbox::Random& random) {
        PoseCase any{"any two cameras", random_pose(random)};
        return any;
      });
}
// END HIDDEN

// ---- epipolar lines (task 10.2) ----

struct LineCase {
  const char* what;
  Matrix essential;
  Camera left, right;
  Pixel pixel;
};

// The essential matrices of the pairs of cameras above, as numbers, so that a mistake in task 10.1
// has no effect on the other tasks.
inline constexpr Matrix kParallelMatrix{{{0, 0, 0}, {0, 0, -0.5}, {0, 0.5, 0}}};
inline constexpr Matrix kConvergingMatrix{
    {{0, 0.0088495575221239076, 0}, {0.125, 0, -1}, {0, 1.0077433628318584, 0}}};
inline constexpr Matrix kArbitraryMatrix{
    {{-0.19504132231404958, -0.60495867768595046, -0.06363636363636363},
     {0.32330578512396696, -0.24330578512396694, -0.8290909090909091},
     {0.32776859504132227, 0.61223140495867778, -0.19636363636363635}}};

inline std::vector<LineCase> lines() {
  const Camera same{800, 320, 240}, wide{500, 310, 250};
  return {
      {"parallel axes, where the line is the pixel's own row",
       kParallelMatrix,
       same,
       same,
       {100, 77}},
      {"converging axes", kConvergingMatrix, same, same, {500, 100}},
      {"two different cameras in general position", kArbitraryMatrix, same, wide, {220.5, 400.5}}};
}
// BEGIN HIDDEN
// Makes R S for the inputs. The student's own function essential() is not used, so that its
// mistakes have no effect on the other tasks.
inline Matrix given_essential(const Pose& pose) {
  Matrix e{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& r = pose.rotation[i];
    const Vector& t = pose.translation;
    e[i] = {r[1] * t[2] - r[2] * t[1], r[2] * t[0] - r[0] * t[2], r[0] * t[1] - r[1] * t[0]};
  }
  return e;
}

inline std::vector<LineCase> hidden_lines() {
  const Camera same{800, 320, 240}, long_lens{2400, 960, 540};
  return glassbox::labs::with_varied(
      std::vector<LineCase>{
          {"a right camera above the left one, where the line is a column",
           given_essential({not_turned(), {0, -0.5, 0}}),
           same,
           same,
           {100, 77}},
          {"the epipole itself, which has no line",
           given_essential({not_turned(), {0, 0, 2}}),
           same,
           same,
           {320, 240}},
          {"a row, from a matrix with the opposite sign",
           given_essential({not_turned(), {-0.5, 0, 0}}),
           same,
           same,
           {100, 77}},
          {"a left camera with a long focal length", kArbitraryMatrix, long_lens, same, {1700, 12}},
          {"beside the picture", kConvergingMatrix, same, same, {-4000, 2500}}},
      102, 3, [](glassbox::Random& random) {
        const Matrix e = given_essential(random_pose(random));
        const Camera left{random.between(300, 900), random.between(200, 400), 240};
        const Camera right{random.between(300, 900), random.between(200, 400), 240};
        return LineCase{
            "any two cameras", e, left, right, {random.between(0, 640), random.between(0, 480)}};
      });
}
// END HIDDEN

// ---- points (task 10.3) ----

struct PointsCase {
  const char* what;
  std::vector<Pixel> points;
};
inline std::vector<PointsCase> points() {
  return {{"two points", {{0, 0}, {2, 0}}},
          {"a square beside the origin", {{10, 20}, {14, 20}, {14, 24}, {10, 24}}},
          {"five points", {{0.1, -0.2}, {0.4, 0.3}, {-0.25, 0.15}, {0.05, 0.6}, {-0.3, -0.45}}}};
}
// BEGIN HIDDEN
inline std::vector<PointsCase> hidden_points() {
  glassbox::Random random = glassbox::labs::varied(103);
  PointsCase pixels{"forty pixels", {}};
  for (int i = 0; i < 40; ++i) {
    const double x = random.between(0, 640);
    pixels.points.push_back({x, random.between(0, 480)});
  }
  return {pixels,
          {"a column", {{7, 1}, {7, 2}, {7, 5}}},
          {"far away", {{1e6, 1e6}, {1e6 + 1, 1e6 - 3}}}};
}
// END HIDDEN

// ---- matches (tasks 10.4 and 10.5) ----

struct MatchesCase {
  std::string what;
  Pose pose;  // of the cameras; matches with noise do not fit it exactly
  std::vector<Match> matches;
};

// The matches of random points that are in front of both cameras and up to `farthest` away. The
// matches' calibrated coordinates have random errors of up to `noise`.
inline MatchesCase seen_by(const std::string& what, const Pose& pose, int count, double noise,
                           std::uint64_t seed, double farthest = 9) {
  glassbox::Random random(seed);
  const auto off = [&] { return random.between(-noise, noise); };
  MatchesCase made{what, pose, {}};
  while (int(made.matches.size()) < count) {
    const double x = random.between(-0.5, 0.5), y = random.between(-0.4, 0.4);
    const double z = random.between(2, farthest);
    const Vector from_right = plus({x * z, y * z, z}, times(-1, pose.translation));
    const Vector p = times(pose.rotation, from_right);
    if (!(p[2] > 0.5)) continue;
    const double left_x = x + off(), left_y = y + off();
    const double right_x = p[0] / p[2] + off();
    made.matches.push_back({{left_x, left_y}, {right_x, p[1] / p[2] + off()}});
  }
  return made;
}

inline std::vector<MatchesCase> matches() {
  return {seen_by("eight exact matches", arbitrary_pose(), 8, 0, 1),
          seen_by("thirty exact matches of converging cameras", converging_pose(), 30, 0, 2),
          seen_by("thirty matches with noise", arbitrary_pose(), 30, 2e-3, 3),
          seen_by("twelve matches with more noise", converging_pose(), 12, 5e-3, 4)};
}
// BEGIN HIDDEN
inline std::vector<MatchesCase> hidden_matches() {
  return glassbox::labs::with_varied(
      std::vector<MatchesCase>{
          seen_by("one camera in front of the other", {turned_by(20, 1, 0.5, 1), {0.2, 0.1, 0.9}},
                  40, 1e-3, 5),
          seen_by("a right camera that is turned by 90 degrees about its gaze",
                  {turned_by(1, 0, 0, 1), {0.7, 0.2, 0.1}}, 20, 1e-3, 6),
          seen_by("a hundred matches with much noise", arbitrary_pose(), 100, 1e-2, 7)},
      104, 3, [](glassbox::Random& random) {
        const Pose pose = random_pose(random);
        return seen_by("any two cameras", pose, 40, 1e-3, random.bits());
      });
}
// END HIDDEN

struct ChoiceCase {
  std::string what;
  Matrix essential;
  std::vector<Match> matches;
};
inline ChoiceCase choice(const std::string& what, const Pose& pose, const Matrix& e, double sign,
                         int count, std::uint64_t seed) {
  return {what,
          {times(sign, e[0]), times(sign, e[1]), times(sign, e[2])},
          seen_by(what, pose, count, 0, seed).matches};
}
inline std::vector<ChoiceCase> choices() {
  const Matrix to_the_left{{{0.0066298342541436465, -0.019337016574585655, 0.059116022099447531},
                            {0.10022099447513812, -0.0039779005524861882, 0.60530386740331488},
                            {-0.099558011049723755, -0.60795580110497238, 0.010607734806629835}}};
  return {choice("converging cameras", converging_pose(), kConvergingMatrix, 1, 10, 11),
          choice("the same cameras with the opposite sign of E", converging_pose(),
                 kConvergingMatrix, -1, 10, 11),
          choice("any two cameras", arbitrary_pose(), kArbitraryMatrix, 1, 10, 12),
          choice("a right camera that is to the left of the left one",
                 {turned_by(15, 0, -1, 0.5), {-0.6, 0.1, 0.1}}, to_the_left, -1, 10, 13)};
}
// BEGIN HIDDEN
inline ChoiceCase hidden_choice(const std::string& what, const Pose& pose, double sign, int count,
                                std::uint64_t seed) {
  return choice(what, pose, given_essential(pose), sign, count, seed);
}
inline std::vector<ChoiceCase> hidden_choices() {
  std::vector<ChoiceCase> all{
      hidden_choice("a quarter turn", {turned_by(1, 0, 0, 1), {0.3, 0.7, -0.2}}, 1, 9, 14),
      hidden_choice("one camera behind the other, and an E of any length",
                    {turned_by(30, 1, 0, 1), {1, 5, -30}}, -1, 9, 15),
      hidden_choice("one match", arbitrary_pose(), 1, 1, 16)};
  // Translations in many directions: depending on the direction, a wrong pose has the points behind
  // the left camera or behind the right one.
  const std::vector<Vector> directions{{0.1, 0.9, 0.1},  {0.1, -0.9, 0.1}, {0.2, 0.1, -1},
                                       {-0.9, 0.3, 0.2}, {0.1, 0.2, 1},    {0.6, 0.6, -0.5}};
  for (std::size_t i = 0; i < directions.size(); ++i)
    all.push_back(hidden_choice("translations in several directions",
                                {turned_by(10, 1, -0.5, 0.7), directions[i]}, 1, 9, 20 + i));
  ChoiceCase wrong =
      hidden_choice("nine matches, of which one is wrong", arbitrary_pose(), 1, 9, 17);
  wrong.matches[0].right.x = wrong.matches[0].right.x + 0.9;
  all.push_back(wrong);
  return glassbox::labs::with_varied(all, 105, 3, [](glassbox::Random& random) {
    const Pose pose = random_pose(random);
    const double side = random.unit() < 0.5 ? 1 : -1;
    return hidden_choice("any two cameras", pose, side, 12, random.bits());
  });
}
// END HIDDEN

// ---- lines of sight (task 10.6) ----

struct RaysCase {
  const char* what;
  Pixel left, right;
  Pose pose;
};
inline Pixel seen_from_right(const Pose& pose, const Vector& point) {
  const Vector p = times(pose.rotation, plus(point, times(-1, pose.translation)));
  return {p[0] / p[2], p[1] / p[2]};
}
inline std::vector<RaysCase> rays() {
  const Vector point{0.5, -0.25, 4};
  return {{"lines of sight that meet",
           {0.125, -0.0625},
           seen_from_right(arbitrary_pose(), point),
           arbitrary_pose()},
          {"lines of sight that do not meet", {0.125, -0.0625}, {0.02, 0.05}, converging_pose()},
          {"parallel axes, and pixels of different rows",
           {0.25, 0.125},
           {0.125, 0.25},
           parallel_pose()},
          {"parallel lines (C-107)", {0.25, 0.125}, {0.25, 0.125}, parallel_pose()},
          {"a point behind both cameras", {0.125, 0}, {0.25, 0}, parallel_pose()}};
}
// BEGIN HIDDEN
// The lines of sight of both cameras to an infinitely far point. They are parallel, but rounding
// makes their directions slightly different.
inline RaysCase parallel_rays(const char* what, const Pose& pose) {
  const Vector p = times(pose.rotation, Vector{0.3, -0.2, 1});
  return {what, {0.3, -0.2}, {p[0] / p[2], p[1] / p[2]}, pose};
}
inline std::vector<RaysCase> hidden_rays() {
  return glassbox::labs::with_varied(
      std::vector<RaysCase>{
          {"a short baseline (C-109)", {0.3, 0.2}, {0.2999, 0.2001}, {not_turned(), {1e-3, 0, 0}}},
          {"along the baseline (C-108)", {0.01, 0.02}, {0.0125, 0.024}, {not_turned(), {0, 0, 1}}},
          {"nearly perpendicular", {0.5, 0.1}, {-0.5, 0.2}, {turned_by(2, 0, 1, 0), {3, 0, 1}}},
          {"cameras that look at each other",
           {0.1, 0.05},
           {0.12, -0.04},
           {turned_by(0, 0, 1, 0), {0, 0, 9}}},
          parallel_rays("parallel lines of sight of turned cameras", arbitrary_pose()),
          parallel_rays("parallel lines of sight of cameras that are turned further",
                        {turned_by(3, -1, 2, 1), {0.5, 0.5, 0}}),
          parallel_rays("parallel lines of sight of cameras that are turned to the other side",
                        {turned_by(7, 2, -1, -1), {1, 0, 0.5}})},
      106, 3, [](glassbox::Random& random) {
        const Pose pose = random_pose(random);
        const double x = random.between(-0.4, 0.4), y = random.between(-0.4, 0.4);
        const double z = random.between(2, 9);
        Pixel right = seen_from_right(pose, {x * z, y * z, z});
        right.y += random.between(-0.01, 0.01);
        return RaysCase{"random lines of sight", {x, y}, right, pose};
      });
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_10
