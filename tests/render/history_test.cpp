// A pixel's history is what happened there: it ends in the picture's bytes, and leaves no fragment out.
#include <glassbox/render/trace/history.h>

#include <string>

#include <nlohmann/json.hpp>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/trace/history_json.h>

#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

struct Case {
  std::string name;
  Scene scene;
  View view;
  RenderSettings settings;
};

// Squares that face the camera, one behind the other, each with its own material.
struct Square {
  double z = 0, size = 1, x = 0;  // world units; the camera looks down -z from the origin
  Material material;
};

Scene squares(const std::vector<Square>& all) {
  Scene scene;
  scene.name = "squares";
  for (const Square& square : all) {
    Mesh mesh;
    mesh.name = "square " + std::to_string(scene.meshes.size());
    const float s = float(square.size), x = float(square.x), z = float(square.z);
    mesh.positions = {{x - s, -s, z}, {x + s, -s, z}, {x + s, s, z}, {x - s, s, z}};
    // Alpha from 0 on the left to 1 on the right, times the material's.
    mesh.colors = {{1, 1, 1, 0}, {1, 1, 1, 1}};
    mesh.corners = {
        {0, kNone, kNone, 0}, {1, kNone, kNone, 1}, {2, kNone, kNone, 1}, {3, kNone, kNone, 0}};
    mesh.faces = {{0, 4}};
    mesh.material = std::uint32_t(scene.materials.size());
    scene.materials.push_back(square.material);
    scene.nodes.push_back(Node{"", kNone, {}, {}});
    scene.instances.push_back(
        {std::uint32_t(scene.meshes.size()), std::uint32_t(scene.nodes.size() - 1)});
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

Material material(AlphaMode mode, const Rgba& color, float cutoff = 0.5f) {
  Material m;
  m.base_color = color;
  m.alpha_mode = mode;
  m.alpha_cutoff = cutoff;
  m.unlit = true;
  return m;
}

View view_of(const Scene& scene, int width, int height, double near = 0) {
  Camera camera;
  camera.lens = PerspectiveLens{1.2, 0.5, 20.0};
  if (!scene.cameras.empty()) camera = scene.cameras.front();
  if (auto* lens = std::get_if<PerspectiveLens>(&camera.lens); lens != nullptr && near > 0) {
    lens->near = near;
  }
  const auto view = make_view(camera, width, height);
  REQUIRE(view);
  return *view;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const Scene blended =
      squares({{-9, 6, 0, material(AlphaMode::kOpaque, {0.9f, 0.2f, 0.1f, 1})},
               {-3, 1, 0.4, material(AlphaMode::kBlend, {0.1f, 0.9f, 0.2f, 1})},
               {-5, 2, -1, material(AlphaMode::kBlend, {0.1f, 0.3f, 0.9f, 0.5f})},
               {-4, 1, -1, material(AlphaMode::kOpaque, {0.2f, 0.2f, 0.2f, 1})},
               {-2, 1, 0, material(AlphaMode::kBlend, {0.9f, 0.9f, 0.2f, 1.5f})}});
  all.push_back({"blended", blended, view_of(blended, 40, 30), {}});

  const Scene cut = squares({{-3, 1, 0.4, material(AlphaMode::kMask, {0.1f, 0.9f, 0.2f, 1})},
                             {-5, 2, -1, material(AlphaMode::kMask, {0.1f, 0.3f, 0.9f, 1}, 0.2f)},
                             {-9, 6, 0, material(AlphaMode::kOpaque, {0.9f, 0.2f, 0.1f, 1})},
                             {-2, 1, 0, material(AlphaMode::kBlend, {0.9f, 0.9f, 0.2f, 0.5f})}});
  Case masked{"cut out, red and alpha only", cut, view_of(cut, 40, 30), {}};
  masked.settings.mask = {true, false, false, true};
  all.push_back(masked);
  Case nothing{"cut out, all channels masked", cut, view_of(cut, 24, 18), {}};
  nothing.settings.mask = {false, false, false, false};
  all.push_back(nothing);

  const auto room = make_builtin("room");
  REQUIRE(room);
  Case real{"room, a near plane through the furniture", *room, view_of(*room, 48, 36, 2.5), {}};
  all.push_back(real);
  const auto forest = make_builtin("forest");
  REQUIRE(forest);
  all.push_back({"forest, 16-bit depth", *forest, view_of(*forest, 32, 24), {}});
  all.back().settings.depth = DepthFormat::kUnorm16;
  return all;
}

TEST_CASE("a pixel's history ends in the picture's bytes and has every fragment, for every pixel") {
  for (const Case& c : cases()) {
    INFO(c.name);
    const TracedRun run = trace(c.scene, c.view, c.settings, {});
    RenderSettings counting = c.settings;
    counting.show = Show::kOverdraw;
    const Image<std::uint32_t> writes = render_staged(c.scene, c.view, counting).buffers.writes;
    Statistics sums;
    const Image<Rgba8>& picture = run.rendering.buffers.color;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        CAPTURE(x, y);
        const PixelHistory history = pixel_history(c.scene, run, x, y);
        REQUIRE(history.shown == picture.at(x, y));
        REQUIRE(history.shows_bytes);
        REQUIRE(history.shown ==
                (history.shows ? history.events[*history.shows].after : history.cleared));
        Rgba8 bytes = history.cleared;
        std::uint32_t written = 0, depth = kEmptyDepth;
        for (const PixelEvent& event : history.events) {
          if (!is_fragment(event)) continue;
          ++sums.covered;
          REQUIRE(event.stored == depth);
          sums.depth_failed += event.touch == Touch::kHidden ? 1 : 0;
          sums.discarded += event.touch == Touch::kDiscarded ? 1 : 0;
          if (event.touch < Touch::kMasked) continue;
          ++written;
          REQUIRE(event.before == bytes);
          bytes = event.after;
          if (event.touch == Touch::kWritten ||
              (event.touch == Touch::kMasked && event.code < depth &&
               c.scene.materials[c.scene.meshes[event.instance].material].alpha_mode !=
                   AlphaMode::kBlend)) {
            depth = event.code;
          }
        }
        REQUIRE(bytes == history.shown);
        REQUIRE(written == writes.at(x, y));
        sums.written += written;
      }
    }
    CHECK(sums.covered == run.rendering.statistics.covered);
    CHECK(sums.depth_failed == run.rendering.statistics.depth_failed);
    CHECK(sums.discarded == run.rendering.statistics.discarded);
    CHECK(sums.written == run.rendering.statistics.written);
  }
}

TEST_CASE("a run that is traced for one pixel tells the history that a full trace tells") {
  for (const Case& c : cases()) {
    INFO(c.name);
    const TracedRun run = trace(c.scene, c.view, c.settings, {});
    const Image<Rgba8>& picture = run.rendering.buffers.color;
    for (int y = 1; y < picture.height; y += 7) {
      for (int x = y % 5; x < picture.width; x += 9) {
        CAPTURE(x, y);
        const auto expected = to_json(c.scene, pixel_history(c.scene, run, x, y));
        const auto found = to_json(c.scene, pixel_history(c.scene, c.view, c.settings, x, y));
        REQUIRE(found.dump() == expected.dump());
      }
    }
  }
}

}  // namespace
}  // namespace glassbox::test
