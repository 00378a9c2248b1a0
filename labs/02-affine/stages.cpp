// Calls your functions with the transforms of a scene's objects.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_02 {
namespace {

using glassbox::labs::append_matrix;
using glassbox::labs::append_point;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// Input: a matrix that should be a rotation. Output: a rotation.
void repair(RecordReader& in, Numbers& out) {
  append_matrix(out, repaired(in.matrix<Transform<World, World>>()));
}

// Input: a rotation. Output: its axis and angle.
void axis(RecordReader& in, Numbers& out) {
  const AxisAngle found = axis_angle_of(in.matrix<Transform<World, World>>());
  append_point(out, found.axis);
  out.push_back(found.radians);
}

// Input: steps, each as its kind, v, amount, changed and by. Output: their matrix.
void compose_steps(RecordReader& in, Numbers& out) {
  std::vector<Step> steps;
  while (in.more()) {
    Step step;
    step.kind = Step::Kind(in.integer());
    step.v = in.point<Vector<World, double>>();
    step.amount = in.number();
    step.changed = in.integer();
    step.by = in.integer();
    steps.push_back(step);
  }
  append_matrix(out, compose(steps));
}

}  // namespace
}  // namespace lab_02

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_02;
  return {{"repair", repair}, {"axis", axis}, {"place", compose_steps}};
}
