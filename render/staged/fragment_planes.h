// The planes of the framebuffer that belong to pixel centres: everything but the colours.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glassbox/render/engine/distance.h>
#include <glassbox/render/staged/fragments.h>

namespace glassbox {

// Where a fragment does not come from a triangle.
inline constexpr FragmentSource kLineOrPoint{0, 0, false};

inline void write_planes(const FragmentStage& stage, const Fragment& fragment, std::uint32_t code,
                         std::uint32_t id, bool writes_depth) {
  Framebuffer& target = stage.target;
  const std::size_t pixel = target.depth.index(fragment.x, fragment.y);
  if (writes_depth) target.depth.pixels[pixel] = code;
  if (!target.distance.pixels.empty()) {
    target.distance.pixels[pixel] =
        distance_along_gaze(stage.view, fragment.depth, fragment.inverse_w);
  }
  if (!target.id.pixels.empty()) target.id.pixels[pixel] = id;
  if (!target.writes.pixels.empty()) ++target.writes.pixels[pixel];
}

}  // namespace glassbox
