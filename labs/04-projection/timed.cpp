// Transforms vertices by your projection and your divide, for glassbox lab measure.
#include <vector>

#include "labs/framework/stages.h"
#include "student.h"

namespace lab_04 {
namespace {

using glassbox::World;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

struct ParsedQuestion {
  bool reversed = false;
  double fovy_radians = 1, aspect = 1, near = 1, far = 2;
  glassbox::Transform<Eye, World> eye_from_world;
  std::vector<Point<World, double>> points;
};

// Reads 1 where depth is reversed; fovy, aspect, near, far; a view matrix, row by row; then
// vertices.
ParsedQuestion read(RecordReader& in) {
  ParsedQuestion asked;
  asked.reversed = in.number() != 0;
  asked.fovy_radians = in.number();
  asked.aspect = in.number();
  asked.near = in.number();
  asked.far = in.number();
  asked.eye_from_world = in.matrix<glassbox::Transform<Eye, World>>();
  while (in.more()) asked.points.push_back(in.point<Point<World, double>>());
  return asked;
}

// Writes the depth of each vertex; stops at one that is not in front of the eye.
void depths(const ParsedQuestion& asked, Numbers& out) {
  Projection m = perspective(asked.fovy_radians, asked.aspect, asked.near, asked.far);
  if (asked.reversed) m = in_dialect(m, Dialect::kReversed);
  for (const auto& p : asked.points) {
    const auto ndc = divide(m * (asked.eye_from_world * p));
    if (!ndc) return;
    out.push_back(ndc->z);
  }
}

void answer(RecordReader& in, Numbers& out) {
  depths(read(in), out);
}

std::function<void()> prepare(RecordReader& in) {
  return [asked = read(in), out = Numbers()]() mutable {
    out.clear();
    depths(asked, out);
  };
}

}  // namespace
}  // namespace lab_04

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_04::answer, lab_04::prepare}};
}
