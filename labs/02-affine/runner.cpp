// Calls your functions with the cases of lab 2.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_02 {
namespace {

using glassbox::labs::Answer;
using glassbox::labs::entries;

std::vector<double> numbers(const Matrix3& m) {
  std::vector<double> all;
  for (const auto& row : m.at) all.insert(all.end(), row, row + 3);
  return all;
}

void ask_turn(const TurnCase& input, Answer& answer) {
  answer.emit("matrix", numbers(turn_about(input.centre, input.degrees)));
}

void ask_compose(const ComposeCase& input, Answer& answer) {
  answer.emit("world_from_object", entries(compose(input.steps)));
}

// Also says whether there is a map, since there may be none.
void ask_fit(const FitCase& input, Answer& answer) {
  const auto m = fit_affine(input.source, input.target);
  answer.emit("there is a map", {m ? 1.0 : 0.0});
  if (!m) return;
  answer.emit("linear part", {m->at[0][0], m->at[0][1], m->at[1][0], m->at[1][1]});
  answer.emit("last column", {m->at[0][2], m->at[1][2]});
  answer.emit("last row", {m->at[2][0], m->at[2][1], m->at[2][2]});
  answer.emit("map", numbers(*m));
}

void ask_line(const LineCase& input, Answer& answer) {
  const std::array<Point2, 3> target{{{0, 0}, {1, 0}, {0, 1}}};
  answer.emit("on a line", {fit_affine(input.on_a_line, target) ? 1.0 : 0.0});
  answer.emit("not on a line", {fit_affine(input.off_it, target) ? 1.0 : 0.0});
}

void ask_axis(const RotationCase& input, Answer& answer) {
  const AxisAngle found = axis_angle_of(rotation_of(input));
  answer.emit("axis", {found.axis.x, found.axis.y, found.axis.z});
  answer.emit("angle", {found.radians});
}

void ask_repair(const DriftCase& input, Answer& answer) {
  answer.emit("rotation", entries(repaired(input.matrix)));
}

}  // namespace
}  // namespace lab_02

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_02;
  return {
      check("the plane turns about a point", turns(), ask_turn),
      check("one step", single_steps(), ask_compose),
      check("steps one after the other", compositions(), ask_compose),
      check("three points determine a map", fits(), ask_fit),
      check("three points on a line do not", lines(), ask_line),
      check("axis and angle", rotations(), ask_axis),
      check("axis and angle near no turn and half a turn", stiff_rotations(), ask_axis),
      check("what has drifted is a rotation again", drifts(), ask_repair),
      generated_check("any turn", generated_turns(), ask_turn),
      generated_check("any steps", generated_compositions(), ask_compose),
      generated_check("any three points", generated_fits(), ask_fit),
      generated_check("any rotation", generated_rotations(), ask_axis),
      generated_check("any drift", generated_drifts(), ask_repair),
      // BEGIN HIDDEN
      check("other points and angles", hidden_turns(), ask_turn),
      check("mirrors, shears and deep hierarchies", hidden_compositions(), ask_compose),
      check("needles and flat targets", hidden_fits(), ask_fit),
      check("other axes and angles", hidden_rotations(), ask_axis),
      check("other drifts", hidden_drifts(), ask_repair),
      // END HIDDEN
  };
}
