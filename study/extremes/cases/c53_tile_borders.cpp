#include <cstdlib>

#include "study/extremes/kit/coverage.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/screen_scene.h"
#include "study/naive/tiles.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c53 {

constexpr int kSide = 256;

// Vertices on corners and edges of tiles, or within half a pixel of them.
std::vector<ScreenTriangle> triangles() {
  Random random(53);
  std::vector<ScreenTriangle> all;
  for (int i = 0; i < 400; ++i) {
    ScreenTriangle t;
    for (ScreenVertex& v : t) {
      const auto coordinate = [&] {
        return double(random.integer(0, 16)) * 16 + double(random.integer(-1, 1)) * 0.5;
      };
      v = screen_vertex(coordinate(), coordinate());
    }
    all.push_back(t);
  }
  return all;
}

// Draws triangles tile by tile.
using Tiled =
    std::function<TrianglesDrawn(const std::vector<ScreenTriangle>&, int side, int threads)>;

Outcome judge(const Tiled& tiled) {
  const std::vector<ScreenTriangle> all = triangles();
  const TrianglesDrawn whole = triangles_drawn(all, kSide);
  std::int64_t wrong = 0, times = 0;
  int ways = 0;
  for (const auto& [side, threads] : std::initializer_list<std::pair<int, int>>{
           {16, 1}, {16, 16}, {32, 3}, {64, 1}, {64, 8}, {128, 2}, {256, 4}}) {
    const TrianglesDrawn drawn = tiled(all, side, threads);
    for (std::size_t i = 0; i < whole.first.pixels.size(); ++i) {
      wrong += drawn.first.pixels[i] != whole.first.pixels[i];
      times += drawn.times.pixels[i] != whole.times.pixels[i];
    }
    ++ways;
  }
  return must_be_zero(double(wrong + times),
                      fmt::format("{} pixels show another triangle, {} are drawn too often or not "
                                  "often enough, with {} tile sizes and numbers of threads",
                                  wrong, times, ways));
}

TrianglesDrawn engine(const std::vector<ScreenTriangle>& all, int side, int threads) {
  return drawn_by_tile_engine(all, kSide, {.threads = threads, .tile_side = side});
}

Tiled naive_tiles(const naive::TileRules& rules) {
  return [rules](const std::vector<ScreenTriangle>& all, int side, int) {
    return naive::drawn_by_tiles(all, kSide, side, rules);
  };
}

}  // namespace c53

ExtremeCase c53_tile_borders() {
  using namespace c53;
  return {
      .id = "C-53",
      .name = "Tile borders",
      .construction =
          "400 triangles with vertices on tile corners, or half a pixel beside them; tiles of 16 "
          "to 256 px, 1 to 16 threads",
      .stage = "tiles",
      .right = "every pixel as often as without tiles",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"the tile engine", [] { return judge(engine); }},
      .naive = {"a triangle goes to the tiles that hold its vertices",
                [] { return judge(naive_tiles({.only_tiles_of_vertices = true})); }},
      .mutants = {{"tiles reach one pixel too far",
                   [] { return judge(naive_tiles({.pixels_too_far = 1})); }},
                  {"tiles end one pixel too early",
                   [] { return judge(naive_tiles({.pixels_too_far = -1})); }}},
      .pictures = {{"naive",
                    [] {
                      const std::vector<ScreenTriangle> first{triangles().front()};
                      return coverage_png(
                          naive::drawn_by_tiles(first, kSide, 16, {.only_tiles_of_vertices = true})
                              .first,
                          2);
                    }}},
  };
}

}  // namespace glassbox::study
