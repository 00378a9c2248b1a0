// Calls your clipper with triangles, for glassbox lab measure.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_05 {
namespace {

using glassbox::labs::append_point;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;
using Triangle = std::array<Point<Clip>, 3>;

// Reads triangles: the corners of each in clip space.
std::vector<Triangle> triangles(RecordReader& in) {
  std::vector<Triangle> all;
  while (in.more()) {
    for (Point<Clip>& p : all.emplace_back()) p = in.point<Point<Clip>>();
  }
  return all;
}

// Clips a triangle. The outcodes are tested first, because most triangles are inside all planes, or
// outside one of them.
Polygon clipped_triangle(const Triangle& triangle) {
  std::vector<std::uint32_t> codes;
  for (const Point<Clip>& p : triangle) codes.push_back(outcode(p));
  const Verdict verdict = trivial_verdict(codes);
  if (verdict == Verdict::kReject) return {};
  if (verdict == Verdict::kAccept) return {triangle.begin(), triangle.end()};
  return clip_to_frustum(triangle);
}

// Writes for each triangle the number of vertices that are left, and these vertices.
void answer(RecordReader& in, Numbers& out) {
  for (const Triangle& triangle : triangles(in)) {
    const Polygon left = clipped_triangle(triangle);
    out.push_back(double(left.size()));
    for (const Point<Clip>& p : left) append_point(out, p);
  }
}

std::function<void()> prepare(RecordReader& in) {
  return [all = triangles(in)] {
    for (const Triangle& triangle : all) clipped_triangle(triangle);
  };
}

}  // namespace
}  // namespace lab_05

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_05::answer, lab_05::prepare}};
}
