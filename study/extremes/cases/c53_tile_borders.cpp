#include <cstdlib>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/screen_scene.h"
#include "study/naive/tiles.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c53 {

constexpr int kSide = 256;

// Triangles with vertices on corners and edges of tiles, or up to one and a half pixels away from
// them.
std::vector<std::vector<ScreenTriangle>> triangle_lists() {
  Random random(53);
  std::vector<std::vector<ScreenTriangle>> all(20);
  for (int i = 0; i < 400; ++i) {
    const std::int64_t left = random.integer(0, 13), top = random.integer(0, 13);
    ScreenTriangle t;
    for (ScreenVertex& v : t) {
      // Every second triangle is at most 48 px large.
      const auto coordinate = [&](std::int64_t from) {
        const std::int64_t corner =
            i % 2 == 0 ? random.integer(0, 16) : from + random.integer(0, 3);
        return double(corner) * 16 + double(random.integer(-3, 3)) * 0.5;
      };
      const double x = coordinate(left), y = coordinate(top);
      v = screen_vertex(x, y);
    }
    all[std::size_t(i) / 20].push_back(t);
  }
  return all;
}

// Draws triangles tile by tile.
using Tiled =
    std::function<TriangleCoverage(const std::vector<ScreenTriangle>&, int side, int threads)>;

Outcome measure_error(const Tiled& tiled) {
  Outcome worst;
  for (const std::vector<ScreenTriangle>& all : triangle_lists()) {
    const TriangleCoverage whole = covered_exactly(all, kSide);
    for (const auto& [side, threads] : std::initializer_list<std::pair<int, int>>{
             {16, 1}, {16, 16}, {32, 3}, {64, 1}, {64, 8}, {128, 2}, {256, 4}}) {
      worst = worse_of(compare(tiled(all, side, threads), whole), worst);
    }
  }
  return worst;
}

TriangleCoverage tile_engine_coverage(const std::vector<ScreenTriangle>& all, int side,
                                      int threads) {
  return draw_coverage(tile_engine("", {.threads = threads, .tile_side = side}), all, kSide);
}

Tiled naive_tiles(const naive::TileRules& rules) {
  return [rules](const std::vector<ScreenTriangle>& all, int side, int) {
    TriangleCoverage drawn = naive::drawn_by_tiles(all, kSide, side, rules);
    for (int& times : drawn.times.pixels) times = std::min(times, kMaxLayers);
    return drawn;
  };
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<CoverageReference> pictures = [] {
    std::vector<CoverageReference> all;
    for (const auto& triangles : triangle_lists()) all.emplace_back(triangles, kSide);
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c53

ExtremeCase c53_tile_borders() {
  using namespace c53;
  return {
      .id = "C-53",
      .name = "Tile borders",
      .construction =
          "20 pictures of 20 triangles with vertices on tile corners, or up to a pixel and a half "
          "beside them; "
          "tiles of 16 to 256 px, 1 to 16 threads",
      .stage = "tiles",
      .right_answer = "every pixel is covered as often as without tiles, in 128 bits",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"the tile engine", [] { return measure_error(tile_engine_coverage); }},
      .naive = {"a triangle goes to the tiles that hold its vertices",
                [] { return measure_error(naive_tiles({.only_tiles_of_vertices = true})); }},
      .mutants = {{"tiles reach one pixel too far",
                   [] { return measure_error(naive_tiles({.pixels_too_far = 1})); }},
                  {"tiles end one pixel too early",
                   [] { return measure_error(naive_tiles({.pixels_too_far = -1})); }}},
      .drawn = measure_drawn_error,
      .pictures = {{"naive",
                    [] {
                      const std::vector<ScreenTriangle> first{triangle_lists()[0][0]};
                      return coverage_png(
                          naive::drawn_by_tiles(first, kSide, 16, {.only_tiles_of_vertices = true})
                              .first,
                          2);
                    }}},
  };
}

}  // namespace glassbox::study
