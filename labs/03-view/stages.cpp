// Puts the camera and the matrices of a scene to your functions.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_03 {
namespace {

using glassbox::labs::append_matrix;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// 0 for U, V, N and 1 for two rotations; eye, target and up. The matrix; nothing where there is none.
void view(RecordReader& in, Numbers& out) {
  const bool by_rotations = in.number() != 0;
  Camera camera;
  camera.eye = in.place<Point<World, double>>();
  camera.target = in.place<Point<World, double>>();
  camera.up = in.place<Vector<World, double>>();
  if (by_rotations) return append_matrix(out, axis_angle_view(camera));
  if (const auto made = uvn_view(camera)) append_matrix(out, *made);
}

// A projection for the left-handed eye. The same for ours.
void hand(RecordReader& in, Numbers& out) {
  append_matrix(out, for_right_handed_eye(in.matrix<Transform<Clip, Eye>>()));
}

// A model matrix. What it is.
void kind(RecordReader& in, Numbers& out) {
  out.push_back(double(kind_of(in.matrix<Transform<World, World>>())));
}

}  // namespace
}  // namespace lab_03

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_03;
  return {{"view", view}, {"hand", hand}, {"kind", kind}};
}
