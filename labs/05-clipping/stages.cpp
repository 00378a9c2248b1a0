// Calls your functions with the triangles of a scene.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_05 {
namespace {

using glassbox::labs::append_point;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// Input: three corners in clip space. Output: their outcodes, the verdict, and the clipped polygon.
void clip(RecordReader& in, Numbers& out) {
  std::array<Point<Clip>, 3> triangle;
  for (Point<Clip>& p : triangle) p = in.point<Point<Clip>>();
  std::vector<std::uint32_t> codes;
  for (const Point<Clip>& p : triangle) codes.push_back(outcode(p));
  out.insert(out.end(), codes.begin(), codes.end());
  const Verdict verdict = trivial_verdict(codes);
  out.push_back(double(verdict));
  if (verdict == Verdict::kReject) return;
  Polygon left(triangle.begin(), triangle.end());
  if (verdict == Verdict::kClip) left = clip_to_frustum(triangle);
  for (const Point<Clip>& p : left) append_point(out, p);
}

// Input: the eye, then the corners of a face, in world space. Output: 1 for a back face, else 0.
void facing(RecordReader& in, Numbers& out) {
  const auto eye = in.point<Point<World>>();
  std::vector<Point<World>> face;
  while (in.more()) face.push_back(in.point<Point<World>>());
  out.push_back(is_back_face(face, eye) ? 1 : 0);
}

}  // namespace
}  // namespace lab_05

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"clip", lab_05::clip}, {"facing", lab_05::facing}};
}
