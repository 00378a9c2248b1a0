// The tile engine against the staged reference: every plane of the framebuffer, byte for byte.
#pragma once

#include <string>

#include <glassbox/render/staged.h>
#include <glassbox/render/tile/tile_engine.h>

#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox::test {

template <class Pixel>
std::size_t differing_pixels(const Image<Pixel>& a, const Image<Pixel>& b) {
  if (a.width != b.width || a.height != b.height) return std::size_t(-1);
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) count += !(a.pixels[i] == b.pixels[i]);
  return count;
}

inline void check_same_planes(const Framebuffer& staged, const Framebuffer& tiled) {
  CHECK(differing_pixels(staged.color, tiled.color) == 0);
  if (!tiled.depth.pixels.empty()) CHECK(differing_pixels(staged.depth, tiled.depth) == 0);
  CHECK(differing_pixels(staged.distance, tiled.distance) == 0);
  CHECK(differing_pixels(staged.id, tiled.id) == 0);
  CHECK(differing_pixels(staged.writes, tiled.writes) == 0);
}

// What went through the stages before the depth test. (Behind it, the engines look at different fragments.)
inline void check_same_counts(const Statistics& staged, const Statistics& tiled) {
  CHECK(staged.triangles == tiled.triangles);
  CHECK(staged.rejected == tiled.rejected);
  CHECK(staged.clipped == tiled.clipped);
  CHECK(staged.clipped_away == tiled.clipped_away);
  CHECK(staged.after_clipping == tiled.after_clipping);
  CHECK(staged.zero_area == tiled.zero_area);
  CHECK(staged.culled == tiled.culled);
  CHECK(staged.set_up == tiled.set_up);
}

inline void check_same(const Scene& scene, const View& view, const RenderSettings& settings,
                       const TileOptions& options = {}) {
  INFO("target " << name_of(options.target) << ", threads " << options.threads << ", tiles of "
                 << options.tile_side);
  const Rendering staged = render_staged(scene, view, settings);
  const Rendering tiled = render_tiled(scene, view, settings, options);
  check_same_planes(staged.buffers, tiled.buffers);
  check_same_counts(staged.statistics, tiled.statistics);
}

}  // namespace glassbox::test
