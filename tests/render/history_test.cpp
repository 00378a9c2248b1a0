// A pixel's history lists all that happened in the pixel: it ends with the bytes of the picture,
// and no fragment is missing.
#include <glassbox/render/trace/history.h>

#include <cmath>
#include <string>
#include <variant>

#include <nlohmann/json.hpp>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/raster/triangle_setup.h>
#include "app/pixel/history_json.h"

#include <glassbox/base/random.h>
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

struct HistoryCase {
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

Scene squares_of(const std::vector<Square>& all) {
  Scene scene;
  scene.name = "squares";
  for (const Square& square : all) {
    Mesh mesh;
    mesh.name = "square " + std::to_string(scene.meshes.size());
    const float s = float(square.size), x = float(square.x), z = float(square.z);
    mesh.positions = {{x - s, -s, z}, {x + s, -s, z}, {x + s, s, z}, {x - s, s, z}};
    // Alpha rises from 0 on the left to 1 on the right, and is multiplied by the material's.
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

View history_view(const Scene& scene, int width, int height, double near = 0) {
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

std::vector<HistoryCase> history_cases() {
  std::vector<HistoryCase> all;
  const Scene blended =
      squares_of({{-9, 6, 0, material(AlphaMode::kOpaque, {0.9f, 0.2f, 0.1f, 1})},
                  {-3, 1, 0.4, material(AlphaMode::kBlend, {0.1f, 0.9f, 0.2f, 1})},
                  {-5, 2, -1, material(AlphaMode::kBlend, {0.1f, 0.3f, 0.9f, 0.5f})},
                  {-4, 1, -1, material(AlphaMode::kOpaque, {0.2f, 0.2f, 0.2f, 1})},
                  {-2, 1, 0, material(AlphaMode::kBlend, {0.9f, 0.9f, 0.2f, 1.5f})}});
  all.push_back({"blended", blended, history_view(blended, 40, 30), {}});

  const Scene cut =
      squares_of({{-3, 1, 0.4, material(AlphaMode::kMask, {0.1f, 0.9f, 0.2f, 1})},
                  {-5, 2, -1, material(AlphaMode::kMask, {0.1f, 0.3f, 0.9f, 1}, 0.2f)},
                  {-9, 6, 0, material(AlphaMode::kOpaque, {0.9f, 0.2f, 0.1f, 1})},
                  {-2, 1, 0, material(AlphaMode::kBlend, {0.9f, 0.9f, 0.2f, 0.5f})}});
  HistoryCase masked{"cut out, red and alpha only", cut, history_view(cut, 40, 30), {}};
  masked.settings.mask = {true, false, false, true};
  all.push_back(masked);
  HistoryCase nothing{"cut out, all channels masked", cut, history_view(cut, 24, 18), {}};
  nothing.settings.mask = {false, false, false, false};
  all.push_back(nothing);

  const auto room = make_builtin("room");
  REQUIRE(room);
  HistoryCase real{
      "room, a near plane through the furniture", *room, history_view(*room, 48, 36, 2.5), {}};
  all.push_back(real);
  const auto forest = make_builtin("forest");
  REQUIRE(forest);
  all.push_back({"forest, 16-bit depth", *forest, history_view(*forest, 32, 24), {}});
  all.back().settings.depth = DepthFormat::kUnorm16;
  return all;
}

TEST_CASE("a pixel's history ends in the picture's bytes and has every fragment, for every pixel") {
  for (const HistoryCase& c : history_cases()) {
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
          REQUIRE(event.stored ==
                  (event.stored_by ? history.events[*event.stored_by].code : kEmptyDepth));
          sums.depth_failed += event.kind == PixelEventKind::kHidden ? 1 : 0;
          sums.discarded += event.kind == PixelEventKind::kDiscarded ? 1 : 0;
          if (event.kind < PixelEventKind::kMasked) continue;
          ++written;
          REQUIRE(event.before == bytes);
          bytes = event.after;
          if (event.writes_depth) depth = event.code;
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
  for (const HistoryCase& c : history_cases()) {
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

// ---- triangles that left no fragment ----

// A view of 64 x 64 px with screen x = 32 + 32 x/w, y = 32 - 32 y/w, w = -z, near 1, far 2.
View exact_view() {
  const auto view = make_view({"", FrustumLens{-1, 1, -1, 1, 1, 2.0}, {}}, 64, 64);
  REQUIRE(view);
  return *view;
}

Point<Object> at(double x, double y, double w) {
  return {float((x - 32) / 32 * w), float((32 - y) / 32 * w), float(-w)};
}

Scene triangles(const std::vector<Point<Object>>& corners, Material look = {}) {
  Mesh mesh;
  mesh.positions = corners;
  for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3) add_face(mesh, {i, i + 1, i + 2});
  look.unlit = true;
  return scene_of(mesh, look);
}

PixelHistory history_at(const Scene& scene, int x, int y, const RenderSettings& settings = {}) {
  return pixel_history(scene, exact_view(), settings, x, y);
}

TEST_CASE(
    "a triangle that was turned away is in the history of the pixels that it would have covered") {
  const Scene scene = triangles({at(8, 8, 1.5), at(24, 8, 1.5), at(8, 24, 1.5)});
  const PixelHistory inside = history_at(scene, 10, 10);
  REQUIRE(inside.events.size() == 1);
  CHECK(inside.events[0].kind == PixelEventKind::kTurnedAway);
  CHECK(inside.events[0].area_px2 == -128);
  CHECK(!inside.events[0].front);
  CHECK(!inside.shows);
  CHECK(inside.shown == RenderSettings{}.background);
  const PixelHistory beside = history_at(scene, 22, 22);
  CHECK(beside.events.empty());
  CHECK(beside.misses.empty());
}

TEST_CASE("what a plane cut off is in the history of the pixels that it would have covered") {
  // A wall from w = 0.5 at the top of the picture to 1.5 at the bottom: the near plane keeps its
  // lower part.
  const std::vector<Point<Object>> wall{{-1, 0.5f, -0.5f}, {-3, -1.5f, -1.5f}, {3, -1.5f, -1.5f}};
  const Scene scene = triangles(wall);
  int kept = 0, cut = 0;
  for (int y = 0; y < 64; ++y) {
    const PixelHistory history = history_at(scene, 8, y);
    if (history.events.empty()) continue;
    REQUIRE(history.events.size() == 1);
    const PixelEvent& event = history.events[0];
    // The wall's plane is y = 1.5 - 2 w, and the line of sight through the pixel's centre is y =
    // (31.5 - row)/32 w.
    const double w = 1.5 / (2 + (31.5 - y) / 32);
    CHECK(double(event.distance) == Approx(w).epsilon(1e-6));
    if (event.kind == PixelEventKind::kClipped) {
      ++cut;
      CHECK(std::string(event.plane) == "near");
      CHECK(w < 1);
      CHECK(event.inside == Approx(2 * w - 2).epsilon(1e-6));
      CHECK(event.front);
    } else {
      ++kept;
      CHECK(event.kind == PixelEventKind::kWritten);
      CHECK(w >= 1);
    }
  }
  CHECK(kept == 16);  // w >= 1 from row 48 on
  CHECK(cut == 28);   // the wall begins at w = 3/4.734, in row 20

  // One triangle is wholly nearer than the near plane, the other wholly farther than the far plane.
  const Scene gone = triangles(
      {at(8, 8, 0.5), at(8, 24, 0.5), at(24, 8, 0.5), at(8, 8, 3), at(8, 24, 3), at(24, 8, 3)});
  const PixelHistory history = history_at(gone, 10, 10);
  REQUIRE(history.events.size() == 2);
  CHECK(std::string(history.events[0].plane) == "near");
  CHECK(history.events[0].distance == 0.5f);
  CHECK(history.events[0].inside == -1);
  CHECK(std::string(history.events[1].plane) == "far");
  CHECK(history.events[1].distance == 3);
  CHECK(history.events[1].inside == -1);
  CHECK(history_at(gone, 40, 40).events.empty());
}

TEST_CASE("triangles that miss a pixel's centre are told by how much, the nearest first") {
  // Edges 26 and 52 steps to the right of the centre of pixel (10, 10), and one through it, at
  // which its triangle ends.
  const double near = 10.5 + 26.0 / 256, far = 10.5 + 52.0 / 256;
  const Scene scene = triangles({at(far, 4, 1), at(far, 20, 1), at(40, 4, 1),    //
                                 at(near, 4, 1), at(near, 20, 1), at(40, 4, 1),  //
                                 at(10.5, 4, 1), at(2, 4, 1), at(10.5, 20, 1),   //
                                 at(13, 4, 1), at(13, 20, 1), at(40, 4, 1)});
  const PixelHistory history = history_at(scene, 10, 10);
  CHECK(history.events.empty());
  REQUIRE(history.misses.size() == 3);
  CHECK(history.misses[0].number == 2);
  CHECK(history.misses[0].miss.value == 0);
  CHECK(history.misses[0].miss.subpixels == 0);
  CHECK(history.misses[1].number == 1);
  CHECK(history.misses[1].miss.subpixels == 26);
  CHECK(history.misses[1].miss.value == -26 * 16 * 256);
  CHECK(history.misses[2].number == 0);
  CHECK(history.misses[2].miss.subpixels == 52);
}

TEST_CASE("the nearest miss is the least of the misses of all pixels") {
  Random random(7);
  int compared = 0;
  for (int round = 0; round < 4000; ++round) {
    std::array<ScreenVertex, 3> vertices;
    const double width = random.between(0, 12), height = random.between(0, 0.2);
    for (ScreenVertex& vertex : vertices) {
      vertex.position.x = float(6 + random.between(0, width));
      vertex.position.y =
          float(8.02 + random.between(0, height) + 0.25 * double(vertex.position.x));
    }
    const auto setup = setup_triangle(vertices);
    if (!setup) continue;
    const PixelRect pixels{0, 0, 24, 20};
    std::optional<double> least;
    bool covered = false;
    for (int y = 0; y < pixels.y1; ++y) {
      for (int x = 0; x < pixels.x1; ++x) {
        const auto miss = miss_at(*setup, x, y);
        covered = covered || !miss;
        if (miss && (!least || miss->subpixels < *least)) least = miss->subpixels;
      }
    }
    if (covered) continue;
    ++compared;
    const CentreMiss nearest = nearest_miss(*setup, pixels);
    CAPTURE(round, nearest.x, nearest.y);
    REQUIRE(nearest.subpixels == *least);
    REQUIRE(miss_at(*setup, nearest.x, nearest.y)->value == nearest.value);
  }
  CHECK(compared > 500);
}

}  // namespace
}  // namespace glassbox::test
