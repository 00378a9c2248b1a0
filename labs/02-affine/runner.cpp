// Puts the cases of lab 2 to your functions.
#include "labs/framework/runner.h"
#include "cases.h"
#include "student.h"

namespace lab_02 {
namespace {

using glassbox::labs::Answer;
using glassbox::labs::RunnerCheck;

std::vector<double> numbers(const Matrix3& m) {
  std::vector<double> all;
  for (const auto& row : m.at) all.insert(all.end(), row, row + 3);
  return all;
}

template <class Target, class Source>
std::vector<double> numbers(const Transform<Target, Source>& m) {
  std::vector<double> all;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) all.push_back(m.at(i, j));
  }
  return all;
}

RunnerCheck turn_checks(const std::string& name, const std::vector<TurnCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const TurnCase& each = cases[std::size_t(index)];
            answer.emit("matrix", numbers(turn_about(each.centre, each.degrees)));
          }};
}

RunnerCheck compose_checks(const std::string& name, const std::vector<ComposeCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            answer.emit("world_from_object", numbers(compose(cases[std::size_t(index)].steps)));
          }};
}

RunnerCheck fit_checks(const std::string& name, const std::vector<FitCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const FitCase& each = cases[std::size_t(index)];
            const auto m = fit_affine(each.source, each.target);
            if (!m) return;
            answer.emit("linear part", {m->at[0][0], m->at[0][1], m->at[1][0], m->at[1][1]});
            answer.emit("map", numbers(*m));
          }};
}

RunnerCheck line_checks(const std::string& name, const std::vector<LineCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const LineCase& each = cases[std::size_t(index)];
            const std::array<Point2, 3> target{{{0, 0}, {1, 0}, {0, 1}}};
            answer.emit("on a line", {fit_affine(each.on_a_line, target) ? 1.0 : 0.0});
            answer.emit("off it", {fit_affine(each.off_it, target) ? 1.0 : 0.0});
          }};
}

RunnerCheck axis_checks(const std::string& name, const std::vector<RotationCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const AxisAngle found = axis_angle_of(rotation_of(cases[std::size_t(index)]));
            answer.emit("axis", {found.axis.x, found.axis.y, found.axis.z});
            answer.emit("angle", {found.radians});
          }};
}

RunnerCheck repair_checks(const std::string& name, const std::vector<DriftCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            answer.emit("rotation", numbers(repaired(cases[std::size_t(index)].matrix)));
          }};
}

}  // namespace
}  // namespace lab_02

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_02;
  return {
      turn_checks("the plane turns about a point", turns()),
      compose_checks("one step", single_steps()),
      compose_checks("steps one after the other", compositions()),
      fit_checks("three points determine a map", fits()),
      line_checks("three points on a line do not", lines()),
      axis_checks("axis and angle", rotations()),
      axis_checks("axis and angle near no turn and half a turn", stiff_rotations()),
      repair_checks("what has drifted is a rotation again", drifts()),
      // BEGIN HIDDEN
      turn_checks("other points and angles", hidden_turns()),
      compose_checks("mirrors, shears and deep hierarchies", hidden_compositions()),
      fit_checks("needles and flat targets", hidden_fits()),
      axis_checks("other axes and angles", hidden_rotations()),
      repair_checks("other drifts", hidden_drifts()),
      // END HIDDEN
  };
}
