// Calls your functions with the cases of lab 3.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_03 {
namespace {

using glassbox::labs::Answer;
using glassbox::labs::entries;

void emit_view(const Transform<Eye, World>& view, Answer& answer) {
  answer.emit("rotation", entries(view, 3, 3));
  answer.emit("eye_from_world", entries(view));
}

// Also says whether there is a view, since there may be none.
void ask_uvn(const CameraCase& input, Answer& answer) {
  const auto view = uvn_view(input.camera);
  answer.emit("there is a view", {view ? 1.0 : 0.0});
  if (view) emit_view(*view, answer);
}

void ask_refused(const RefusedCase& input, Answer& answer) {
  answer.emit("answer without a view", {uvn_view(input.bad) ? 1.0 : 0.0});
  answer.emit("answer with a view", {uvn_view(input.good) ? 1.0 : 0.0});
}

void ask_onto(const OntoCase& input, Answer& answer) {
  answer.emit("rotation", entries(rotation_onto(input.from, input.to), 3, 3));
}

void ask_axis_angle(const CameraCase& input, Answer& answer) {
  emit_view(axis_angle_view(input.camera), answer);
}

void ask_kind(const KindCase& input, Answer& answer) {
  const Kind found = kind_of(input.matrix);
  std::vector<double> is;
  for (const Kind each : {Kind::kNeither, Kind::kRotation, Kind::kMirror})
    is.push_back(found == each ? 1 : 0);
  answer.emit("neither, rotation, mirror", is);
}

void ask_hand(const HandCase& input, Answer& answer) {
  answer.emit("clip_from_eye", entries(for_right_handed_eye(watt_projection(input))));
}

void ask_any_hand(const ProjectionCase& input, Answer& answer) {
  answer.emit("clip_from_eye", entries(for_right_handed_eye(input.matrix)));
}

}  // namespace
}  // namespace lab_03

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_03;
  return {
      check("the view from the axes of the eye", cameras(), ask_uvn),
      check("cameras without a view are refused", refused_cameras(), ask_refused),
      check("one direction onto another", directions(), ask_onto),
      check("half a turn", opposite_directions(), ask_onto),
      check("two rotations give the same view", cameras(), ask_axis_angle),
      check("rotations, mirrors and neither", kinds(), ask_kind),
      check("a left-handed projection for a right-handed eye", hands(), ask_hand),
      generated_check("any camera", generated_cameras(), ask_uvn),
      generated_check("any two directions", generated_directions(), ask_onto),
      generated_check("two rotations, any camera", generated_views(), ask_axis_angle),
      generated_check("any matrix", generated_kinds(), ask_kind),
      generated_check("any projection", generated_projections(), ask_any_hand),
      // BEGIN HIDDEN
      check("other cameras", hidden_cameras(), ask_uvn),
      check("other cameras without a view", hidden_refused_cameras(), ask_refused),
      check("other directions", hidden_directions(), ask_onto),
      check("other half turns", hidden_opposite_directions(), ask_onto),
      check("two rotations, other cameras", hidden_cameras(), ask_axis_angle),
      check("other matrices", hidden_kinds(), ask_kind),
      check("other projections", hidden_hands(), ask_hand),
      // END HIDDEN
  };
}
