// Calls your functions with the inputs of lab 10.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_10 {
namespace {

using glassbox::labs::Answer;

std::vector<double> numbers(const Vector& v) {
  return {v[0], v[1], v[2]};
}
std::vector<double> numbers(const Matrix& m) {
  std::vector<double> all;
  for (const Vector& row : m) all.insert(all.end(), row.begin(), row.end());
  return all;
}

void matrix_of_pose(const PoseCase& input, Answer& answer) {
  answer.emit("E", numbers(essential(input.pose)));
}

// Passes the pose's translation as t, the vector of other textbooks in P_r = R P_l + t.
void centre(const PoseCase& input, Answer& answer) {
  answer.emit("T", numbers(centre_from_shift(input.pose.rotation, input.pose.translation)));
}

void line(const LineCase& input, Answer& answer) {
  const Line l = epipolar_line(input.essential, input.left, input.right, input.pixel);
  answer.emit("a, b", {l.a, l.b});
  answer.emit("c", {l.c});
}

void normaliser(const PointsCase& input, Answer& answer) {
  const Normaliser n = normalising(input.points);
  answer.emit("centre", {n.x, n.y});
  answer.emit("scale", {n.scale});
}

void matrix_of_matches(const MatchesCase& input, Answer& answer) {
  answer.emit("E", numbers(told(eight_point(input.matches))));
}

void pose(const ChoiceCase& input, Answer& answer) {
  const Pose found = relative_pose(input.essential, input.matches);
  answer.emit("R", numbers(found.rotation));
  answer.emit("T", numbers(found.translation));
}

void point(const RaysCase& input, Answer& answer) {
  const Point p = triangulate(input.left, input.right, input.pose);
  answer.emit("point", {p.x, p.y, p.z});
  answer.emit("w", {p.w});
}

}  // namespace
}  // namespace lab_10

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_10;
  return {
      check("the matrix of two cameras", poses(), matrix_of_pose),
      check("the centre of a camera from its shift", poses(), centre),
      check("the line on which the other point lies", lines(), line),
      check("points of the size that suits", points(), normaliser),
      check("the matrix of eight matches and more", matches(), matrix_of_matches),
      check("one pose of four", choices(), pose), check("where lines of sight meet", rays(), point),
      generated_check("the matrix of any two cameras", generated_poses(), matrix_of_pose),
      generated_check("any shift", generated_poses(), centre),
      generated_check("any line", generated_lines(), line),
      generated_check("any points", generated_points(), normaliser),
      generated_check("any matches", generated_matches(), matrix_of_matches),
      generated_check("any pose of four", generated_choices(), pose),
      generated_check("any lines of sight", generated_rays(), point),
      // BEGIN HIDDEN
      check("other cameras", hidden_poses(), matrix_of_pose),
      check("other shifts", hidden_poses(), centre), check("other lines", hidden_lines(), line),
      check("other points of the size that suits", hidden_points(), normaliser),
      check("other matches", hidden_matches(), matrix_of_matches),
      check("other poses", hidden_choices(), pose),
      check("other lines of sight", hidden_rays(), point),
      // END HIDDEN
  };
}
