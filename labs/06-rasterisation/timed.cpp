// Calls your functions with edges and triangles, for glassbox lab measure.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_06 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

SnappedVertex vertex(RecordReader& in) {
  const int x = in.integer();
  return {x, in.integer()};
}

bool is_inside(const SnappedVertex& from, const SnappedVertex& to, const SnappedVertex& centre) {
  const std::int64_t e = edge(from, to, centre);
  return e > 0 || (e == 0 && owns_edge(from, to));
}

std::vector<Triangle> triangles_of(RecordReader& in) {
  std::vector<Triangle> triangles;
  while (in.more()) {
    for (SnappedVertex& v : triangles.emplace_back()) v = vertex(in);
  }
  return triangles;
}

// Input: 0 and edges, each with the centre of a pixel near it. Output: whether the pixel belongs to
// the triangle on the right of the edge, and whether it belongs to the triangle on the left. If the
// input is that of prepare(), which begins with a width: how many pixels each triangle covers.
void answer(RecordReader& in, Numbers& out) {
  if (const int width = in.integer(); width > 0) {
    for (const Triangle& triangle : triangles_of(in))
      out.push_back(double(covered_pixels(triangle, {0, 0, width, width}).size()));
    return;
  }
  while (in.more()) {
    const SnappedVertex from = vertex(in), to = vertex(in), centre = vertex(in);
    out.push_back(is_inside(from, to, centre) ? 1 : 0);
    out.push_back(is_inside(to, from, centre) ? 1 : 0);
  }
}

// Reads the width of a tile at the origin, then triangles.
std::function<void()> prepare(RecordReader& in) {
  const int width = in.integer();
  return [triangles = triangles_of(in), tile = PixelRect{0, 0, width, width}] {
    for (const Triangle& triangle : triangles) covered_pixels(triangle, tile);
  };
}

}  // namespace
}  // namespace lab_06

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_06::answer, lab_06::prepare}};
}
