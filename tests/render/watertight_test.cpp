// Whole runs: from inside a closed surface every pixel is covered exactly once, even where the
// clipper cuts.
#include <algorithm>

#include <glassbox/base/trig.h>
#include <glassbox/render/staged/staged.h>

#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

struct Count {
  std::uint64_t gaps = 0;
  std::uint64_t doubles = 0;  // pixels covered more than once, at any depth
};

Count count_coverage(const Scene& scene, const Camera& camera, int width, int height) {
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  settings.cull = Cull::kNone;
  settings.show = Show::kOverdraw;
  const auto view = make_view(camera, width, height);
  REQUIRE(view);
  const Rendering rendering = render_staged(scene, *view, settings);
  Count count;
  for (const std::uint32_t writes : rendering.buffers.writes.pixels) count.gaps += writes == 0;
  count.doubles =
      rendering.statistics.covered - (rendering.buffers.writes.pixels.size() - count.gaps);
  return count;
}

}  // namespace

TEST_CASE("no pixel seen from inside a closed mesh is left open (C-32, C-38, C-45)") {
  // The surface passes behind the eye on all sides, so triangles cross the near plane. There must
  // be no gaps at the cuts.
  constexpr std::uint64_t kSeed = 32;
  Random random(kSeed);
  for (int trial = 0; trial < 60; ++trial) {
    const int n = int(random.integer(1, 9));
    const Scene scene = test::scene_of(test::star_shaped_surface(n, 0.2, random));
    const PerspectiveLens lens{random.between(0.2, 2.6), 0.001, 100.0};
    const Camera camera = test::random_gaze(
        {random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(-0.1, 0.1)}, lens,
        random);
    INFO("seed " << kSeed << ", trial " << trial << ", grid " << n << ", fovy "
                 << lens.fovy_radians);
    const Count count = count_coverage(scene, camera, 97, 61);
    CHECK(count.gaps == 0);
  }
}

TEST_CASE(
    "no pixel of a convex room is covered twice, also where the guard band cuts (C-36, C-39, "
    "C-40)") {
  constexpr std::uint64_t kSeed = 36;
  Random random(kSeed);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = int(random.integer(1, 5));
    const Scene scene = test::scene_of(test::star_shaped_surface(n, 0.0, random));
    // Angles of view from 0.6 to 179.4 degrees; close to a wall, so that w spans six decades within
    // a triangle.
    const PerspectiveLens lens{random.between(0.01, 3.13), 0.00001, 100.0};
    const Camera camera =
        test::random_gaze({random.between(-0.999, 0.999), random.between(-0.999, 0.999),
                           random.between(-0.999, 0.999)},
                          lens, random);
    INFO("seed " << kSeed << ", trial " << trial << ", grid " << n << ", fovy "
                 << lens.fovy_radians);
    const Count count = count_coverage(scene, camera, 64, 48);
    CHECK(count.gaps == 0);
    CHECK(count.doubles == 0);
  }
}

TEST_CASE("edges that run exactly through pixel centres have one owner in whole pictures (C-43)") {
  // Square pictures with 90 degrees of view along an axis: grid lines and diagonals of quads pass
  // through pixel centres.
  Random random(43);
  for (const int size : {33, 64, 65}) {
    for (const int n : {1, 2, 4}) {
      INFO(size << " x " << size << ", grid " << n);
      const Scene scene = test::scene_of(test::star_shaped_surface(n, 0.0, random));
      const PerspectiveLens lens{kHalfPi, 0.001, 100.0};
      const Camera camera{"axis", lens, inverse_rigid(*look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}))};
      const Count count = count_coverage(scene, camera, size, size);
      CHECK(count.gaps == 0);
      CHECK(count.doubles == 0);
    }
  }
}

}  // namespace glassbox
