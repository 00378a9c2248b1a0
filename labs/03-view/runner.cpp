// Puts the cases of lab 3 to your functions.
#include "labs/framework/runner.h"
#include "cases.h"
#include "student.h"

namespace lab_03 {
namespace {

using glassbox::labs::Answer;
using glassbox::labs::RunnerCheck;

// The upper left `size` x `size`, row by row.
template <class Target, class Source>
std::vector<double> numbers(const Transform<Target, Source>& m, int size) {
  std::vector<double> all;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) all.push_back(m.at(i, j));
  }
  return all;
}

void emit_view(const Transform<Eye, World>& view, Answer& answer) {
  answer.emit("rotation", numbers(view, 3));
  answer.emit("eye_from_world", numbers(view, 4));
}

RunnerCheck uvn(const std::string& name, const std::vector<CameraCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const auto view = uvn_view(cases[std::size_t(index)].camera);
            if (view) emit_view(*view, answer);
          }};
}

RunnerCheck refused(const std::string& name, const std::vector<RefusedCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const RefusedCase& each = cases[std::size_t(index)];
            answer.emit("of the one without", {uvn_view(each.bad) ? 1.0 : 0.0});
            answer.emit("of the other", {uvn_view(each.good) ? 1.0 : 0.0});
          }};
}

RunnerCheck onto(const std::string& name, const std::vector<OntoCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const OntoCase& each = cases[std::size_t(index)];
            answer.emit("rotation", numbers(rotation_onto(each.from, each.to), 3));
          }};
}

RunnerCheck axis_angle(const std::string& name, const std::vector<CameraCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            emit_view(axis_angle_view(cases[std::size_t(index)].camera), answer);
          }};
}

RunnerCheck kind(const std::string& name, const std::vector<KindCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const Kind found = kind_of(cases[std::size_t(index)].matrix);
            std::vector<double> is;
            for (const Kind each : {Kind::kNeither, Kind::kRotation, Kind::kMirror})
              is.push_back(found == each ? 1 : 0);
            answer.emit("neither, rotation, mirror", is);
          }};
}

RunnerCheck hand(const std::string& name, const std::vector<HandCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const auto given = watt_projection(cases[std::size_t(index)]);
            answer.emit("clip_from_eye", numbers(for_right_handed_eye(given), 4));
          }};
}

}  // namespace
}  // namespace lab_03

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_03;
  return {
      uvn("the view from the axes of the eye", cameras()),
      refused("cameras without a view are refused", refused_cameras()),
      onto("one direction onto another", directions()), onto("half a turn", opposite_directions()),
      axis_angle("two rotations give the same view", cameras()),
      kind("rotations, mirrors and neither", kinds()),
      hand("a left-handed projection for a right-handed eye", hands()),
      // BEGIN HIDDEN
      uvn("other cameras", hidden_cameras()),
      refused("other cameras without a view", hidden_refused_cameras()),
      onto("other directions", hidden_directions()),
      onto("other half turns", hidden_opposite_directions()),
      axis_angle("two rotations, other cameras", hidden_cameras()),
      kind("other matrices", hidden_kinds()), hand("other projections", hidden_hands()),
      // END HIDDEN
  };
}
