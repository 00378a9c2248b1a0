// Calls your functions with the projection and the vertices of a scene.
#include <array>

#include "labs/framework/stages.h"
#include "student.h"

namespace lab_04 {
namespace {

using glassbox::labs::append_matrix;
using glassbox::labs::append_point;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// Input: 1 where depth is reversed, else 0; then 1 and fovy, aspect, near, far of a perspective
// view, or 0 and left, right, bottom, top, near, far of a parallel one. Output: the matrix.
void projection(RecordReader& in, Numbers& out) {
  const bool reversed = in.number() != 0, is_perspective = in.number() != 0;
  std::array<double, 6> n{};
  for (double& each : n) each = in.number();
  Projection m = is_perspective ? perspective(n[0], n[1], n[2], n[3])
                                : orthographic(n[0], n[1], n[2], n[3], n[4], n[5]);
  if (reversed) m = in_dialect(m, Dialect::kReversed);
  append_matrix(out, m);
}

// Input: points of clip space. Output: the NDC of each; nothing at all if a point has no NDC.
void divided(RecordReader& in, Numbers& out) {
  Numbers made;
  while (in.more()) {
    const auto ndc = divide(in.point<Point<Clip, double>>());
    if (!ndc) return;
    append_point(made, *ndc);
  }
  out.insert(out.end(), made.begin(), made.end());
}

// Input: the viewport's left, top, width and height, then points in NDC. Output: each point on the
// screen.
void placed(RecordReader& in, Numbers& out) {
  Rectangle viewport;
  viewport.left = in.number();
  viewport.top = in.number();
  viewport.width = in.number();
  viewport.height = in.number();
  while (in.more()) append_point(out, to_screen(in.point<Point<Ndc, double>>(), viewport));
}

// Input: near and far, then depths. Output: the distance that belongs to each depth.
void distances(RecordReader& in, Numbers& out) {
  const double near = in.number(), far = in.number();
  while (in.more()) out.push_back(distance_of(in.number(), near, far));
}

}  // namespace
}  // namespace lab_04

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_04;
  return {{"projection", projection},
          {"divide", divided},
          {"viewport", placed},
          {"distances", distances}};
}
