// Calls your functions with the fragments and the patches of a scene.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_08 {
namespace {

using glassbox::labs::append_point;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

struct Corner {
  double x = 0, y = 0;
  float inverse_w = 1;
};

// Input: the number of pairs of attributes; the width and height of the texture, or 0 if there is
// none (texture coordinates are the first pair); three corners, each with its position on the
// screen, 1/w and its attributes; then pixels, each with x, y and the three edge functions. Output:
// for each pixel its attributes, and the mip level if there is a texture.
void attributes(RecordReader& in, Numbers& out) {
  const auto pairs = std::size_t(in.number());
  const int width = in.integer(), height = in.integer();
  std::array<Corner, 3> corners;
  std::vector<PixelOfTriangle> asked(pairs);
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k].x = in.number();
    corners[k].y = in.number();
    corners[k].inverse_w = in.real();
    for (PixelOfTriangle& pair : asked) {
      pair.inverse_w[k] = corners[k].inverse_w;
      const float first = in.real();
      pair.texcoords[k] = {first, in.real()};
    }
  }
  while (in.more()) {
    const double x = in.number(), y = in.number();
    std::array<std::int64_t, 3> edges;
    for (std::int64_t& e : edges) e = std::int64_t(in.number());
    for (PixelOfTriangle& pair : asked) {
      pair.edges = edges;
      const auto [a, b] = texcoord_at(pair);
      out.insert(out.end(), {double(a), double(b)});
    }
    if (width == 0) continue;
    std::array<TexturedVertex, 3> triangle;
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = {corners[k].x, corners[k].y, corners[k].inverse_w, asked[0].texcoords[k][0],
                     asked[0].texcoords[k][1]};
    out.push_back(footprint_at(triangle, x + 0.5, y + 0.5, width, height).level);
  }
}

// Input: the level, then sixteen control points. Output: the numbers of positions and triangles,
// then the positions and triangles.
void patch(RecordReader& in, Numbers& out) {
  const int level = in.integer();
  Patch asked;
  for (auto& row : asked.rows) {
    for (auto& p : row) p = in.point<Point<Object, double>>();
  }
  const Tessellation made = tessellate(asked, level);
  out.insert(out.end(), {double(made.positions.size()), double(made.triangles.size())});
  for (const auto& p : made.positions) append_point(out, p);
  for (const auto& [a, b, c] : made.triangles)
    out.insert(out.end(), {double(a), double(b), double(c)});
}

}  // namespace
}  // namespace lab_08

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"patch", lab_08::patch}, {"attributes", lab_08::attributes}};
}
