// Calls your cull with triangles, for glassbox lab measure.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_09 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;
using Triangle = std::array<StereoPoint, 3>;

// Reads corners: left x, right x, y, z, w.
std::vector<Triangle> triangles(RecordReader& in) {
  std::vector<Triangle> all;
  while (in.more()) {
    for (StereoPoint& p : all.emplace_back()) {
      p.left_x = in.real();
      p.right_x = in.real();
      p.y = in.real();
      p.z = in.real();
      p.w = in.real();
    }
  }
  return all;
}

// Writes the verdict on each triangle.
void answer(RecordReader& in, Numbers& out) {
  for (const Triangle& triangle : triangles(in)) out.push_back(double(cull(triangle)));
}

std::function<void()> prepare(RecordReader& in) {
  return [all = triangles(in)] {
    for (const Triangle& triangle : all) cull(triangle);
  };
}

}  // namespace
}  // namespace lab_09

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_09::answer, lab_09::prepare}};
}
