// The tile engine writes the bytes of the staged reference (DESIGN 3): for every scene, option, target, number of threads and
// tile size.
#include <glassbox/mesh/builtin/scenes.h>

#include "tests/render/tile/same_picture.h"

namespace glassbox {
namespace {

using test::check_same;

Scene built_in(const std::string& name) {
  const auto scene = make_builtin(name);
  REQUIRE(scene);
  return *scene;
}

View view_of(const Scene& scene, int width, int height, DepthRange range = DepthRange::kStandard) {
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
    const Scene scene = built_in(std::string(builtin.name));
    check_same(scene, view_of(scene, 323, 181), all_planes());
  }
}

TEST_CASE("the tile engine's bytes do not depend on the target, the threads or the tiles",
          "[tile]") {
  for (const char* name : {"teapot:16", "room", "forest"}) {
    INFO(name);
    const Scene scene = built_in(name);
    const View view = view_of(scene, 250, 131);
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
    const Scene scene = built_in(name);
    const auto check_with = [&](RenderSettings settings, const char* what) {
      INFO(name << ", " << what);
      const bool reversed = settings.depth == DepthFormat::kFloat32Reversed;
      check_same(scene,
                 view_of(scene, 160, 90, reversed ? DepthRange::kReversed : DepthRange::kStandard),
                 settings);
      check_same(scene,
                 view_of(scene, 97, 61, reversed ? DepthRange::kReversed : DepthRange::kStandard),
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

// Triangles of some pixels, of which each block has a few: from none to more than a vector has lanes. Nothing but colours is asked for,
// since other planes are found pixel by pixel.
TEST_CASE("pixels that share their triangles are coloured as the staged reference has them",
          "[tile]") {
  for (const char* name : {"sphere:6", "sphere:24", "teapot:3", "teapot:8", "checker", "room"}) {
    const Scene scene = built_in(name);
    for (const Target target : available_targets()) {
      for (const Shading shading : {Shading::kPhong, Shading::kGouraud, Shading::kUnlit}) {
        for (const Cull cull : {Cull::kBack, Cull::kNone}) {
          INFO(name << ", shading " << int(shading) << ", cull " << int(cull));
          RenderSettings s;
          s.shading = shading;
          s.cull = cull;
          check_same(scene, view_of(scene, 150, 93), s, {1, 32, target, true});
        }
      }
    }
  }
}

}  // namespace
}  // namespace glassbox
