// The tile engine writes the same bytes as the staged reference, for every scene, option, target,
// number of threads and tile size.
#include <cmath>
#include <limits>
#include <utility>

#include <glassbox/mesh/builtin/scenes.h>

#include "tests/render/tile/same_picture.h"

namespace glassbox {
namespace {

using test::check_same;

View tile_view_of(const Scene& scene, int width, int height,
                  DepthRange range = DepthRange::kStandard) {
  const auto view =
      make_view(test::camera_for(scene, double(width) / height), width, height, range);
  REQUIRE(view);
  return *view;
}

RenderSettings all_planes(RenderSettings settings = {}) {
  settings.want_depth = settings.want_distance = settings.want_id = true;
  return settings;
}

TEST_CASE("the tile engine draws every built-in scene as the staged reference does", "[tile]") {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    INFO(builtin.name);
    const Scene scene = test::built_in(std::string(builtin.name));
    check_same(scene, tile_view_of(scene, 323, 181), all_planes());
  }
}

TEST_CASE("the tile engine's bytes do not depend on the target, the threads or the tiles",
          "[tile]") {
  for (const char* name : {"teapot:16", "room", "forest"}) {
    INFO(name);
    const Scene scene = test::built_in(name);
    const View view = tile_view_of(scene, 250, 131);
    const RenderSettings settings = all_planes();
    const Rendering staged = render_staged(scene, view, settings);
    for (const Target target : available_targets()) {
      for (const int threads : {1, 2, 8}) {
        for (const int side : {16, 32, 64, 128, 256}) {
          INFO("target " << name_of(target) << ", threads " << threads << ", tiles of " << side);
          const Rendering tiled =
              render_tiled(scene, view, settings, {threads, side, target, true});
          test::check_same_planes(staged.buffers, tiled.buffers);
          test::check_same_counts(staged.statistics, tiled.statistics);
        }
      }
    }
  }
}

TEST_CASE("the tile engine takes every option as the staged reference does", "[tile]") {
  for (const char* name : {"teapot:6", "room", "checker", "f-glyph"}) {
    const Scene scene = test::built_in(name);
    const auto check_with = [&](RenderSettings settings, const char* what) {
      INFO(name << ", " << what);
      const bool reversed = settings.depth == DepthFormat::kFloat32Reversed;
      check_same(
          scene,
          tile_view_of(scene, 160, 90, reversed ? DepthRange::kReversed : DepthRange::kStandard),
          settings);
      check_same(
          scene,
          tile_view_of(scene, 97, 61, reversed ? DepthRange::kReversed : DepthRange::kStandard),
          all_planes(settings), {2, 16, available_targets().front(), true});
    };
    RenderSettings s;
    for (const Shading shading :
         {Shading::kUnlit, Shading::kFlat, Shading::kGouraud, Shading::kPhong}) {
      s = {};
      s.shading = shading;
      check_with(s, "shading");
    }
    for (const Show show : {Show::kDepth, Show::kNormal, Show::kUv, Show::kId, Show::kOverdraw}) {
      s = {};
      s.show = show;
      check_with(s, "show");
    }
    for (const Cull cull : {Cull::kBack, Cull::kFront, Cull::kNone}) {
      s = {};
      s.cull = cull;
      check_with(s, "cull");
    }
    for (const DepthFormat depth :
         {DepthFormat::kFloat32Reversed, DepthFormat::kUnorm24, DepthFormat::kUnorm16}) {
      s = {};
      s.depth = depth;
      check_with(s, "depth");
    }
    s = {};
    s.transfer = Transfer::kNone;
    check_with(s, "transfer none");
    s = {};
    s.wireframe = true;
    check_with(s, "wireframe");
    s = {};
    s.mask = {true, false, false, false};
    check_with(s, "a red mask");
    s = {};
    s.mask = {false, false, false, false};
    check_with(s, "no colours");
  }
}

// Triangles of several pixels, so that a block has few of them: from none to more than a vector has
// lanes. Only colours are requested, since the other planes are computed pixel by pixel.
TEST_CASE(
    "pixels and samples that share their triangles are coloured as the staged reference has them",
    "[tile]") {
  for (const char* name : {"sphere:6", "sphere:24", "teapot:3", "teapot:8", "checker", "room"}) {
    const Scene scene = test::built_in(name);
    for (const Target target : available_targets()) {
      for (const Shading shading : {Shading::kPhong, Shading::kGouraud, Shading::kUnlit}) {
        for (const Cull cull : {Cull::kBack, Cull::kNone}) {
          for (const int samples : {1, cull == Cull::kBack ? 4 : 16}) {
            INFO(name << ", shading " << int(shading) << ", cull " << int(cull) << ", " << samples
                      << " samples");
            RenderSettings s;
            s.shading = shading;
            s.cull = cull;
            s.samples = samples;
            check_same(scene, tile_view_of(scene, 150, 93), s, {1, 32, target, true});
          }
        }
      }
    }
  }
}

// ---- distances near the limits of float ----

// Two triangles of this height, one in front of the other.
Scene two_triangles(float near_z, float far_z, float height) {
  Mesh mesh;
  for (const float z : {near_z, far_z}) {
    const float low = z == near_z ? 0 : -height;
    for (const auto& [x, y] : {std::pair{-height, low}, {height, low}, {0.0f, low + height}}) {
      mesh.positions.push_back({x, y, z});
    }
  }
  test::add_face(mesh, {0, 1, 2});
  test::add_face(mesh, {3, 4, 5});
  return test::scene_of(mesh);
}

// Checks that the engines agree, that the nearer triangle is white and that the other is dark.
void check_depth_picture(const Scene& scene, const Lens& lens) {
  const auto view = make_view({"front", lens, {}}, 48, 36);
  REQUIRE(view);
  RenderSettings settings = all_planes();
  settings.cull = Cull::kNone;
  settings.show = Show::kDepth;
  for (const Target target : available_targets())
    check_same(scene, *view, settings, {1, 32, target});
  const Framebuffer drawn = render_staged(scene, *view, settings).buffers;
  int white = 0, dark = 0;
  for (std::size_t i = 0; i < drawn.id.pixels.size(); ++i) {
    const bool is_drawn = drawn.id.pixels[i] != 0;
    CHECK(std::isfinite(drawn.distance.pixels[i]) == is_drawn);
    if (!is_drawn) continue;
    const Rgba8 c = drawn.color.pixels[i];
    CHECK(c.r == (drawn.id.pixels[i] == 1 ? 255 : 40));
    (c.r == 255 ? white : dark) += 1;
  }
  CHECK(white > 20);
  CHECK(dark > 20);
}

TEST_CASE("what is as far away as a float can be is seen, and not where nothing is", "[tile]") {
  constexpr float kMost = std::numeric_limits<float>::max();
  check_depth_picture(two_triangles(-1e30f, -kMost, kMost / 4), PerspectiveLens{1.2, 0.1, {}});
}

TEST_CASE("a picture of depths holds distances whose difference overflows", "[tile]") {
  check_depth_picture(two_triangles(2e38f, -2e38f, 1), OrthographicLens{2, -2.5e38, 2.5e38});
}

}  // namespace
}  // namespace glassbox
