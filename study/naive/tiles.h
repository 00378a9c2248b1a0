// Draws a picture tile by tile, with errors at the borders of the tiles.
#pragma once

#include <algorithm>
#include <vector>

#include "study/extremes/common/screen_scene.h"

namespace glassbox::study::naive {

struct TileRules {
  // A triangle is drawn only in the tiles that contain its vertices, not in those between.
  bool only_tiles_of_vertices = false;
  // Each tile ends this many pixels too far to the right and down, so that these pixels are drawn
  // twice. If the number is negative, they are not drawn at all.
  int pixels_too_far = 0;
};

inline bool has_a_vertex_in(const ScreenTriangle& t, const PixelRect& tile) {
  return std::ranges::any_of(t, [&](const ScreenVertex& v) {
    return v.position.x >= float(tile.x0) && v.position.x < float(tile.x1) &&
           v.position.y >= float(tile.y0) && v.position.y < float(tile.y1);
  });
}

inline TriangleCoverage drawn_by_tiles(const std::vector<ScreenTriangle>& triangles,
                                       int picture_side, int tile_side, const TileRules& rules) {
  TriangleCoverage drawn{Image<int>(picture_side, picture_side),
                         Image<int>(picture_side, picture_side)};
  for (int y = 0; y < picture_side; y += tile_side) {
    for (int x = 0; x < picture_side; x += tile_side) {
      const PixelRect tile{x, y, x + tile_side, y + tile_side};
      const int end_x = std::min(tile.x1 + rules.pixels_too_far, picture_side);
      const int end_y = std::min(tile.y1 + rules.pixels_too_far, picture_side);
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (rules.only_tiles_of_vertices && !has_a_vertex_in(triangles[i], tile)) continue;
        pipeline_covers(triangles[i], {x, y, end_x, end_y}, [&](int px, int py) {
          if (drawn.times.at(px, py)++ == 0) drawn.first.at(px, py) = int(i) + 1;
        });
      }
    }
  }
  return drawn;
}

}  // namespace glassbox::study::naive
