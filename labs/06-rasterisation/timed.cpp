// Puts edges and triangles to your functions, for glassbox lab measure.
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

// Edges, each with the centre of a pixel near it. Whether the pixel belongs to the triangle on the edge's right, and whether it
// belongs to the other one.
void answer(RecordReader& in, Numbers& out) {
  while (in.more()) {
    const SnappedVertex from = vertex(in), to = vertex(in), centre = vertex(in);
    out.push_back(is_inside(from, to, centre) ? 1 : 0);
    out.push_back(is_inside(to, from, centre) ? 1 : 0);
  }
}

struct Tile {
  PixelRect window;
  std::vector<Triangle> triangles;
};

// The width of a tile at the origin, then triangles.
Tile tile(RecordReader& in) {
  const int width = in.integer();
  Tile read{{0, 0, width, width}, {}};
  while (in.more()) {
    for (SnappedVertex& v : read.triangles.emplace_back()) v = vertex(in);
  }
  return read;
}

std::function<void()> prepare(RecordReader& in) {
  return [tile = tile(in)] {
    for (const Triangle& triangle : tile.triangles) covered_pixels(triangle, tile.window);
  };
}

// How many pixels of the tile each triangle covers.
void answer_timed(RecordReader& in, Numbers& out) {
  const Tile read = tile(in);
  for (const Triangle& triangle : read.triangles)
    out.push_back(double(covered_pixels(triangle, read.window).size()));
}

}  // namespace
}  // namespace lab_06

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_06::answer, lab_06::prepare}, {"timed", lab_06::answer_timed}};
}
