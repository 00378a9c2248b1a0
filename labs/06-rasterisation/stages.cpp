// Calls your functions with the triangles of a scene.
#include <algorithm>
#include <utility>

#include "labs/framework/stages.h"
#include "student.h"

namespace lab_06 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

constexpr int kTile = 64;  // pixels

// Input: positions on the screen in pixels, one number after the other. Output: the positions in
// steps of 1/256 pixel.
void snap_all(RecordReader& in, Numbers& out) {
  while (in.more()) out.push_back(snap(in.real()));
}

SnappedVertex vertex(RecordReader& in) {
  const int x = in.integer();
  return {x, in.integer()};
}

// Input: the vertices of a polygon. Output: the number of the vertex where its fan begins.
void fan(RecordReader& in, Numbers& out) {
  std::vector<SnappedVertex> polygon;
  while (in.more()) polygon.push_back(vertex(in));
  out.push_back(fan_apex(polygon));
}

// The pixels of a tile that are drawn if the student's functions classified the tile as `cover`.
std::vector<Pixel> pixels_of(const Triangle& triangle, const PixelRect& tile, TileCover cover) {
  if (cover == TileCover::kNone) return {};
  if (cover == TileCover::kSome) return covered_pixels(triangle, tile);
  std::vector<Pixel> all;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) all.push_back({x, y});
  }
  return all;
}

// Input: a window and a triangle of non-zero area. Output: its area; which of its edges 12, 20, 01
// it owns; the class of each tile of the window, from left to right and top to bottom; and for each
// covered pixel x, y and the edge functions opposite the vertices 0, 1, 2.
void cover(RecordReader& in, Numbers& out) {
  const int x0 = in.integer(), y0 = in.integer(), x1 = in.integer(), y1 = in.integer();
  Triangle t;
  for (SnappedVertex& v : t) v = vertex(in);
  const std::int64_t area = edge(t[0], t[1], t[2]);
  out.push_back(double(area));
  // The edges in clockwise direction: those of a counter-clockwise triangle are reversed.
  std::array<std::pair<SnappedVertex, SnappedVertex>, 3> edges{
      {{t[1], t[2]}, {t[2], t[0]}, {t[0], t[1]}}};
  if (area < 0) {
    for (auto& [from, to] : edges) std::swap(from, to);
  }
  for (const auto& [from, to] : edges) out.push_back(owns_edge(from, to) ? 1 : 0);
  std::vector<Pixel> pixels;
  for (int top = y0; top < y1; top = (top / kTile + 1) * kTile) {
    for (int left = x0; left < x1; left = (left / kTile + 1) * kTile) {
      const PixelRect tile{left, top, std::min(x1, (left / kTile + 1) * kTile),
                           std::min(y1, (top / kTile + 1) * kTile)};
      const TileCover cover = classify_tile(t, tile);
      out.push_back(double(cover));
      const std::vector<Pixel> some = pixels_of(t, tile, cover);
      pixels.insert(pixels.end(), some.begin(), some.end());
    }
  }
  for (const Pixel& p : pixels) {
    const SnappedVertex centre{p.x * kSteps + kCentre, p.y * kSteps + kCentre};
    out.insert(out.end(), {double(p.x), double(p.y)});
    for (const auto& [from, to] : edges) out.push_back(double(edge(from, to, centre)));
  }
}

}  // namespace
}  // namespace lab_06

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_06;
  return {{"snap", snap_all}, {"fan", fan}, {"cover", cover}};
}
