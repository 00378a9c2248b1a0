// Compares the tile engine with the staged reference: every plane of the framebuffer, byte for
// byte.
#pragma once

#include <string>

#include <glassbox/render/staged/staged.h>
#include <glassbox/render/tile/tile_engine.h>

#include "tests/render/scenes.h"
#include "tests/render/tile/generated_case.h"
#include "tests/render/tile/planes_differ.h"
#include "tests/support/catch.h"

namespace glassbox::test {

inline void check_same_planes(const Framebuffer& staged, const Framebuffer& tiled,
                              bool want_depth = true) {
  CHECK(planes_differ(staged, tiled, want_depth) == "");
}

// Compares the counts of the stages before the depth test (after it, the engines process different
// fragments). Draws that the plan leaves out enter no stage, so their counts are not compared.
inline void check_same_counts(const Statistics& staged, const Statistics& tiled) {
  CHECK(staged.triangles == tiled.triangles);
  if (tiled.left_out > 0) return;
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
  check_same_planes(staged.buffers, tiled.buffers, settings.want_depth);
  check_same_counts(staged.statistics, tiled.statistics);
}

// Fails if `difference`, which says in words where two pictures of a case differ, is not empty. The
// case is then shrunk and printed.
template <class Difference>
void check_no_difference(std::uint64_t seed, GeneratedCase c, const Difference& difference) {
  if (difference(c).empty()) return;
  shrink(c, [&](const GeneratedCase& smaller) { return !difference(smaller).empty(); });
  FAIL_CHECK("seed " << seed << ": " << difference(c) << "\n" << in_words(c));
}

}  // namespace glassbox::test
