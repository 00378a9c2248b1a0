// The verdicts on all triangles of a scene at once.
#include <glassbox/render/trace/scene_verdict.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/result_counter.h>

#include <glassbox/base/random.h>
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

TEST_CASE("the ends of all triangles add up to the run's statistics") {
  struct Case {
    const char* name;
    double near, fovy;
    Cull cull;
  };
  for (const Case& c :
       {Case{"room", 0.1, 1.0, Cull::kMaterial}, Case{"room", 2.5, 2.0, Cull::kNone},
        Case{"forest", 6, 0.4, Cull::kBack}, Case{"depth-ladder", 0.5, 0.6, Cull::kMaterial},
        Case{"f-glyph", 0.1, 0.5, Cull::kFront}, Case{"teapot:3", 0.1, 0.3, Cull::kMaterial}}) {
    INFO(c.name << ", near " << c.near);
    const auto scene = make_builtin(c.name);
    REQUIRE(scene);
    Camera camera = camera_for(*scene, 1.5);
    camera.lens = PerspectiveLens{c.fovy, c.near, 30.0};
    const auto view = make_view(camera, 96, 64);
    REQUIRE(view);
    RenderSettings settings;
    settings.cull = c.cull;
    settings.want_id = true;
    const Rendering rendering = render_staged(*scene, *view, settings);
    const Statistics& s = rendering.statistics;
    const SceneVerdict found = scene_verdict(*scene, *view, settings);
    CHECK(found.triangles == s.triangles);
    CHECK(found.at(TriangleResult::kNoArea).triangles == s.degenerate);
    CHECK(found.at(TriangleResult::kNotFinite).triangles +
              found.at(TriangleResult::kBehindEye).triangles +
              found.at(TriangleResult::kOutsidePlane).triangles ==
          s.rejected);
    CHECK(found.at(TriangleResult::kClippedAway).triangles == s.clipped_away);

    ResultCounter counter(*view, settings, std::nullopt);
    render_staged(*scene, *view, settings, &counter);
    counter.finish();
    TriangleFragmentCounts sum;
    std::vector<std::uint32_t> visible(counter.entries().size());
    for (std::size_t i = 0; i < visible.size(); ++i) {
      const TriangleFragmentCounts& t = counter.entries()[i].fragments;
      REQUIRE(t.covered == t.hidden + t.discarded + t.masked + t.overwritten + t.visible);
      sum.covered += t.covered;
      sum.hidden += t.hidden;
      sum.discarded += t.discarded;
      visible[i] = t.visible;
    }
    CHECK(sum.covered == s.covered);
    CHECK(sum.hidden == s.depth_failed);
    CHECK(sum.discarded == s.discarded);
    // Nothing here is translucent, so each pixel shows one triangle: the one whose number the id
    // plane has.
    for (const std::uint32_t id : rendering.buffers.id.pixels) {
      if (id > 0) --visible[id - 1];
    }
    CHECK(std::count(visible.begin(), visible.end(), 0u) == std::ptrdiff_t(visible.size()));

    // Single verdicts agree with the summary.
    Random random(20);
    for (int i = 0; i < 12; ++i) {
      const auto number = std::uint32_t(random.unit() * double(found.triangles));
      const auto one = triangle_verdict(*scene, *view, settings, number);
      REQUIRE(one);
      CAPTURE(number);
      CHECK(one->result == counter.entries()[number].result());
      CHECK(one->fragments.visible == counter.entries()[number].fragments.visible);
    }
  }
}

}  // namespace
}  // namespace glassbox::test
