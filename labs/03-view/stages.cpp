// Calls your functions with the camera and the matrices of a scene.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_03 {
namespace {

using glassbox::labs::append_matrix;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// Input: 0 for the matrix from the axes U, V, N, or 1 for the one from two rotations; eye, target
// and up. Output: the view matrix; nothing if there is none.
void view(RecordReader& in, Numbers& out) {
  const bool by_rotations = in.number() != 0;
  Camera camera;
  camera.eye = in.point<Point<World, double>>();
  camera.target = in.point<Point<World, double>>();
  camera.up = in.point<Vector<World, double>>();
  if (by_rotations) return append_matrix(out, axis_angle_view(camera));
  if (const auto made = uvn_view(camera)) append_matrix(out, *made);
}

// Input: a projection for a left-handed eye space. Output: the projection for our eye space.
void hand(RecordReader& in, Numbers& out) {
  append_matrix(out, for_right_handed_eye(in.matrix<Transform<Clip, Eye>>()));
}

// Input: a model matrix. Output: its kind (rotation, mirror or neither).
void kind(RecordReader& in, Numbers& out) {
  out.push_back(double(kind_of(in.matrix<Transform<World, World>>())));
}

}  // namespace
}  // namespace lab_03

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_03;
  return {{"view", view}, {"hand", hand}, {"kind", kind}};
}
