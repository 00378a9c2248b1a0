// The words for positions and triangles in the reports of lab 6's checks and of its pictures.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include <glassbox/raster/fan.h>
#include <glassbox/raster/triangle_setup.h>

namespace glassbox::labs {

inline std::string text_of(const SnappedVertex& v) {
  return fmt::format("({}, {})", v.x / 256.0, v.y / 256.0);
}

inline std::string text_of(const std::array<SnappedVertex, 3>& t) {
  const std::int64_t area = double_area(t[0], t[1], t[2]);
  return fmt::format("{} {} {} px, {}", text_of(t[0]), text_of(t[1]), text_of(t[2]),
                     area > 0   ? "clockwise on the screen"
                     : area < 0 ? "counter-clockwise on the screen"
                                : "without area");
}

}  // namespace glassbox::labs
