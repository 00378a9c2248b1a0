// All that enters a stage leaves it or is counted as lost there.
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/staged/staged.h>

#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {

TEST_CASE("the counts of the stages add up for every built-in scene") {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    INFO(builtin.name);
    const Scene scene = *make_builtin(builtin.name);
    const auto view = make_view(test::camera_for(scene, 16.0 / 9), 160, 90);
    REQUIRE(view);
    const Rendering rendering = render_staged(scene, *view, {});
    const Statistics& s = rendering.statistics;

    const std::uint64_t clip_input = s.triangles - s.degenerate;
    const std::uint64_t whole = clip_input - s.rejected - s.clipped_away - s.clipped;
    CHECK(s.after_clipping >= whole + s.clipped);
    CHECK(s.after_clipping == s.zero_area + s.culled + s.set_up);
    CHECK(s.covered == s.depth_failed + s.discarded + s.written);
    CHECK(s.blended <= s.written);
    CHECK(s.written > 0);
  }
}

}  // namespace glassbox
