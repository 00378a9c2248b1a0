// The tile engine, compared with the staged reference on random scenes and on limiting cases of its
// kernels.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/stereo/render_pair.h>

#include "tests/render/tile/generated_case.h"
#include "tests/render/tile/same_picture.h"

namespace glassbox {
namespace {

using test::GeneratedCase;
using test::kCaseDivisor;

std::string difference(const GeneratedCase& c) {
  const Rendering staged = render_staged(c.scene, c.view, c.settings);
  const Rendering tiled = render_tiled(c.scene, c.view, c.settings, c.options);
  return test::planes_differ(staged.buffers, tiled.buffers, c.settings.want_depth);
}

void check_case(std::uint64_t seed, const GeneratedCase& c) {
  test::check_no_difference(seed, c, difference);
}

TEST_CASE("the tile engine draws any triangles as the staged reference does", "[tile]") {
  std::size_t triangles = 0;
  for (std::uint64_t seed = 0; seed < 1200 / kCaseDivisor; ++seed) {
    Random random(seed);
    const GeneratedCase c = test::generate_case(random, 220, 130);
    for (const Mesh& mesh : c.scene.meshes) triangles += mesh.faces.size();
    check_case(seed, c);
  }
  CHECK(triangles > 100000 / kCaseDivisor);
}

// ---- with a plan and without, with one eye and with two ----

// Where the tile engine's picture, with a plan or without, differs from the staged reference's;
// empty if nowhere.
std::string difference_of_plans(const GeneratedCase& c) {
  const Rendering staged = render_staged(c.scene, c.view, c.settings);
  std::string text;
  for (const bool plan : {true, false}) {
    TileOptions options = c.options;
    options.plan = plan;
    const Rendering tiled = render_tiled(c.scene, c.view, c.settings, options);
    const std::string planes =
        test::planes_differ(staged.buffers, tiled.buffers, c.settings.want_depth);
    if (!planes.empty()) text += std::string(plan ? "with a plan: " : "without: ") + planes;
  }
  return text;
}

// Two eyes that write different channels of one picture. Where both may write alpha, it is the
// right eye's.
struct EyesOfCase {
  StereoPair pair;
  AnaglyphMasks masks;
};
std::optional<EyesOfCase> eyes_of(const GeneratedCase& c, Random& random) {
  EyesOfCase eyes;
  eyes.pair.window = c.view.near + random.unit() * 10;
  eyes.pair.half_separation = eyes.pair.window * random.unit() / 10;
  if (!check_pair(c.view, eyes.pair)) return {};
  const ColorMask red{true, false, false, false}, green{false, true, false, false},
      blue{false, false, true, false}, all;
  const auto but = [](const ColorMask& m) { return ColorMask{!m.r, !m.g, !m.b, true}; };
  const ColorMask left[] = {red, green, blue, but(blue), but(red), all};
  const ColorMask& mask = left[random.integer(0, 5)];
  eyes.masks = {mask, but(mask)};
  return eyes;
}
std::string difference_of_pairs(const GeneratedCase& c, const EyesOfCase& eyes) {
  StereoSettings settings{c.settings};
  settings.render.mask = {};  // the eyes' masks replace it
  const StereoRendering staged =
      render_masked_anaglyph(c.scene, c.view, eyes.pair, settings, eyes.masks);
  StereoRendering both = render_pair(c.scene, c.view, eyes.pair, settings);
  for (std::size_t i = 0; i < both.left.color.pixels.size(); ++i) {
    write_masked(eyes.masks.right, both.right.color.pixels[i], both.left.color.pixels[i]);
  }
  both.right.color = {};
  TileEngine engine(c.options);
  StereoRendering tiled;
  render_masked_anaglyph(engine, c.scene, prepare_scene(c.scene, c.settings.transfer), c.view,
                         eyes.pair, settings, eyes.masks, tiled);
  const bool depth = c.settings.want_depth;
  return test::planes_differ(both.left, staged.left, depth) +
         test::planes_differ(staged.left, tiled.left, depth) +
         test::planes_differ(staged.right, tiled.right, depth);
}

// Checks small pictures, so that there can be many: masks, blending, ties, several samples, and
// meshes that are mirrored, sheared or far away. Returns how many cases also had a pair of eyes.
std::size_t check_small_cases(std::uint64_t first, std::uint64_t last) {
  constexpr int kMaxFaces = 24, kLargestSide = 40;
  std::size_t pairs = 0;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    Random random(0x5ca1ab1e + seed);
    GeneratedCase c = test::generate_case(random, kMaxFaces, kLargestSide);
    test::check_no_difference(seed, c, difference_of_plans);
    if (const auto eyes = eyes_of(c, random)) {
      ++pairs;
      const auto& [left, right] = eyes->masks;
      INFO("a pair, window " << eyes->pair.window << ", half separation "
                             << eyes->pair.half_separation << ", masks " << left.r << left.g
                             << left.b << left.a << " and " << right.r << right.g << right.b
                             << right.a);
      test::check_no_difference(seed, c, [&](const GeneratedCase& smaller) {
        return difference_of_pairs(smaller, *eyes);
      });
    }
  }
  return pairs;
}

TEST_CASE("any small scene has the same bytes by the stages, with a plan, without, and in a pair",
          "[tile]") {
  CHECK(check_small_cases(0, 5000 / kCaseDivisor - 1) > 4250 / kCaseDivisor);  // 4482 of 5000
}
// All of them, which takes some minutes: ./glassbox test scenes, or test_render "[.small-scenes]".
// SEEDS=30000-49999 selects these only.
TEST_CASE("100,000 small scenes have the same bytes by the stages, with a plan and without",
          "[.small-scenes]") {
  unsigned long first = 0, last = 99999;
  if (const char* const asked = std::getenv("SEEDS")) {
    REQUIRE(std::sscanf(asked, "%lu-%lu", &first, &last) == 2);
    REQUIRE(first <= last);
  }
  CHECK(check_small_cases(first, last) > (last - first + 1) * 4 / 5);
}

TEST_CASE("the tile engine draws wide, high and large pictures as the staged reference does",
          "[tile]") {
  const int sizes[][2] = {{1, 1},   {1, 97},   {97, 1},   {7, 5},     {65, 63},
                          {64, 64}, {4096, 3}, {3, 4096}, {257, 255}, {16384, 1}};
  for (const auto& [width, height] : sizes) {
    for (const int side : {16, 64, 256}) {
      Random random(std::uint64_t(width * 100 + height));
      GeneratedCase c = test::generate_case(random, 60 / kCaseDivisor + 5, 4);
      // The same scene in a picture of another size.
      const Camera camera{"wide", PerspectiveLens{1.0, 0.1, {}}, {}};
      c.view = *make_view(camera, width, height);
      c.settings.depth = DepthFormat::kFloat32;
      c.options.tile_side = side;
      check_case(std::uint64_t(width), c);
    }
  }
}

// ---- limits of the lanes ----

// A white quad across the screen that faces the viewer at this distance.
Mesh quad_at(float distance, bool with_texcoord_table) {
  Mesh mesh;
  const float s = distance;
  mesh.positions = {{-s, -s, -s}, {s, -s, -s}, {s, s, -s}, {-s, s, -s}};
  if (with_texcoord_table) mesh.texcoords = {{0.1f, 0.7f}};
  test::add_face(mesh, {0, 1, 2, 3});
  return mesh;
}

View view_of_size(int width, int height) {
  return *make_view({"front", PerspectiveLens{1.2, 0.1, {}}, {}}, width, height);
}

void add_instance_of(Mesh mesh, std::uint32_t material, Scene& scene) {
  mesh.material = material;
  scene.instances.push_back({std::uint32_t(scene.meshes.size()), 0});
  scene.meshes.push_back(std::move(mesh));
}

TEST_CASE("triangles drawn over staged primitives meet the screen's edge inside of a tile",
          "[tile]") {
  Scene scene;
  scene.nodes = {Node{"root", kNone, {}, {}}};
  Material mask;
  mask.alpha_mode = AlphaMode::kMask;
  mask.base_color = {1, 0, 0, 1};
  scene.materials = {Material{}, mask};
  // Drawn by lanes and by stages in turn, each in front of the one before.
  for (int i = 0; i < 6; ++i)
    add_instance_of(quad_at(7.0f - float(i), false), std::uint32_t(i % 2), scene);
  // And small triangles.
  Random random(1);
  for (int i = 0; i < 3; ++i) {
    add_instance_of(test::star_shaped_surface(12, 0.3, random), std::uint32_t(i % 2), scene);
    scene.nodes.push_back({"back", kNone, {}, {}});
    scene.nodes.back().world_from_node.at(2, 3) = -3.0 + i;
    scene.instances.back().node = std::uint32_t(scene.nodes.size() - 1);
  }
  for (const auto& [width, height] : {std::pair{61, 47}, std::pair{130, 67}, std::pair{9, 3}}) {
    for (const std::size_t round : {std::size_t{1}, std::size_t{600}, std::size_t{1} << 23}) {
      for (const Target target : available_targets()) {
        RenderSettings settings;
        settings.want_id = settings.want_distance = true;
        test::check_same(scene, view_of_size(width, height), settings,
                         {2, 64, target, true, round});
      }
    }
  }
}

TEST_CASE("a textured mesh has a table of texture coordinates that no corner uses", "[tile]") {
  Scene scene = test::scene_of(quad_at(2, true));
  scene.images = {Image<Rgba8>(2, 2, Rgba8{200, 100, 50, 255})};
  scene.images[0].at(0, 0) = {10, 20, 30, 255};
  scene.textures = {Texture{}};
  scene.materials[0].texture = 0;
  for (const int side : {16, 64}) {
    test::check_same(scene, view_of_size(70, 50), {}, {1, side});
    test::check_same(scene, view_of_size(20, 10), {}, {1, side});
  }
}

TEST_CASE("round after round, draws meet what was drawn before", "[tile]") {
  Random random(7);
  for (int i = 0; i < 40 / kCaseDivisor + 2; ++i) {
    GeneratedCase c = test::generate_case(random, 100, 100);
    for (const std::size_t round : {std::size_t{1}, std::size_t{150}}) {
      c.options.round_size = round;
      check_case(7, c);
    }
  }
}

}  // namespace
}  // namespace glassbox
