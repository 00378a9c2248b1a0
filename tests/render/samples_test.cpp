// Pictures with several samples per pixel, by both engines.
#include <array>
#include <vector>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/raster/samples.h>
#include <glassbox/render/renderer.h>

#include "tests/render/scenes.h"
#include "tests/render/stereo/pairs.h"
#include "tests/render/tile/generated_case.h"
#include "tests/render/tile/same_picture.h"

namespace glassbox {
namespace {

constexpr std::array kCounts{2, 4, 8, 16};

// White and unlit, in a parallel view in which a unit is a pixel and 0 is the middle of the
// picture.
constexpr int kSamplesSide = 16;

View pixel_view() {
  const auto view = make_view({"plan", OrthographicLens{kSamplesSide / 2.0, 0.0, 10.0}, {}},
                              kSamplesSide, kSamplesSide);
  REQUIRE(view);
  return *view;
}

// A position in pixels from the upper left corner.
Point<Object> at_pixel(float x, float y, float distance = 1) {
  return {x - kSamplesSide / 2, kSamplesSide / 2 - y, -distance};
}

Material white(float alpha = 1, AlphaMode mode = AlphaMode::kOpaque) {
  Material material;
  material.unlit = true;
  material.double_sided = true;
  material.base_color = {1, 1, 1, alpha};
  material.alpha_mode = mode;
  return material;
}

Mesh rectangle(float x0, float y0, float x1, float y1) {
  Mesh mesh;
  mesh.positions = {at_pixel(x0, y0), at_pixel(x1, y0), at_pixel(x1, y1), at_pixel(x0, y1)};
  test::add_face(mesh, {0, 1, 2, 3});
  return mesh;
}

RenderSettings plain(int samples) {
  RenderSettings settings;
  settings.samples = samples;
  settings.transfer = Transfer::kNone;
  settings.background = {0, 0, 0, 255};
  return settings;
}

Image<Rgba8> picture_of(const Scene& scene, const RenderSettings& settings) {
  test::check_same(scene, pixel_view(), settings, {2, 16});
  return render_staged(scene, pixel_view(), settings).buffers.color;
}

// The byte of n white samples among S: (2 n 255 + S) / (2 S).
int share(int n, int samples) {
  return (2 * n * 255 + samples) / (2 * samples);
}

}  // namespace

TEST_CASE("an upright edge passes a pixel's samples one at a time") {
  for (const int samples : kCounts) {
    for (int sixteenth = 0; sixteenth <= 16; ++sixteenth) {
      CAPTURE(samples, sixteenth);
      const Scene scene = test::scene_of(rectangle(2, 2, 5 + float(sixteenth) / 16, 9), white());
      const Image<Rgba8> picture = picture_of(scene, plain(samples));
      int inside = 0;
      for (const SampleOffset& s : sample_offsets(samples)) inside += (s.x + 128) / 16 < sixteenth;
      CHECK(int(picture.at(5, 4).g) == share(inside, samples));
      CHECK(int(picture.at(4, 4).g) == 255);
      CHECK(int(picture.at(6, 4).g) == 0);
    }
  }
}

TEST_CASE("a pixel's colour is the mean of light, unless bytes are no light") {
  const Scene scene = test::scene_of(rectangle(2, 2, 5.5f, 9), white());
  RenderSettings settings = plain(4);
  CHECK(picture_of(scene, settings).at(5, 4) == Rgba8{128, 128, 128, 255});
  settings.transfer = Transfer::kSrgb;
  CHECK(picture_of(scene, settings).at(5, 4) == Rgba8{188, 188, 188, 255});
  settings.show = Show::kUv;  // (0, 0), blended over black
  settings.background = {200, 200, 200, 255};
  CHECK(picture_of(scene, settings).at(5, 4) == Rgba8{100, 100, 100, 255});
}

TEST_CASE("what lies over some samples is blended with those alone") {
  const Scene scene = test::scene_of(rectangle(2, 2, 5.5f, 9), white(0.5f, AlphaMode::kBlend));
  const Image<Rgba8> picture = picture_of(scene, plain(8));
  CHECK(picture.at(3, 4).g == 128);  // floor(127.5 + 0.5)
  CHECK(picture.at(5, 4).g == 64);   // four samples of 128, four of 0
}

TEST_CASE("of two surfaces, each sample shows the nearer one") {
  // A white rectangle, and in front of it a black one that covers half of pixel 5.
  Scene scene = test::scene_of(rectangle(2, 2, 9, 9), white());
  Mesh front = rectangle(5.5f, 2, 9, 9);
  for (auto& p : front.positions) p.z = -0.5f;
  front.material = 1;
  scene.materials.push_back(white());
  scene.materials[1].base_color = {0, 0, 0, 1};
  for (const bool front_first : {false, true}) {
    Scene both = scene;
    both.meshes =
        front_first ? std::vector{front, scene.meshes[0]} : std::vector{scene.meshes[0], front};
    both.instances = {{0, 0}, {1, 0}};
    const Image<Rgba8> picture = picture_of(both, plain(16));
    CHECK(picture.at(4, 4).g == 255);
    CHECK(picture.at(5, 4).g == share(8, 16));
    CHECK(picture.at(6, 4).g == 0);
  }
}

TEST_CASE("where two surfaces cross within a pixel, each sample has its own depth") {
  // White at distance 1; black crosses it at x = 5.5 + 1/32 px and is nearer to the right of that.
  constexpr float kCrossing = 5.5f + 1.0f / 32;
  Scene scene = test::scene_of(rectangle(2, 2, 9, 9), white());
  Mesh black;
  const auto corner = [&](float x, float y) { return at_pixel(x, y, 1 - 0.1f * (x - kCrossing)); };
  black.positions = {corner(2, 2), corner(9, 2), corner(9, 9), corner(2, 9)};
  test::add_face(black, {0, 1, 2, 3});
  black.material = 1;
  scene.materials.push_back(white());
  scene.materials[1].base_color = {0, 0, 0, 1};
  scene.meshes.push_back(black);
  scene.instances.push_back({1, 0});
  for (const int samples : kCounts) {
    const Image<Rgba8> picture = picture_of(scene, plain(samples));
    int left = 0;
    for (const SampleOffset& s : sample_offsets(samples)) left += s.x <= 0;
    CAPTURE(samples);
    CHECK(int(picture.at(4, 4).g) == 255);
    CHECK(int(picture.at(5, 4).g) == share(left, samples));
    CHECK(int(picture.at(6, 4).g) == 0);
  }
}

TEST_CASE("a line is a pixel wide, and a point is a pixel, wherever they lie") {
  Mesh mesh;
  mesh.positions = {at_pixel(4.5f, 2), at_pixel(4.5f, 12),    at_pixel(8, 2),
                    at_pixel(8, 12),   at_pixel(12.5f, 4.5f), at_pixel(13, 9.5f)};
  mesh.lines = {{Corner{0}, Corner{1}}, {Corner{2}, Corner{3}}};
  mesh.points = {Corner{4}, Corner{5}};
  const Scene scene = test::scene_of(mesh, white());
  for (const int samples : kCounts) {
    const Image<Rgba8> picture = picture_of(scene, plain(samples));
    const int half = share(samples / 2, samples);
    const std::array<std::array<int, 3>, 9> expected{{{3, 5, 0},
                                                      {4, 5, 255},
                                                      {5, 5, 0},
                                                      {6, 5, 0},
                                                      {7, 5, half},
                                                      {8, 5, half},
                                                      {12, 4, 255},
                                                      {12, 9, half},
                                                      {11, 4, 0}}};
    for (const auto& [x, y, byte] : expected) {
      CAPTURE(samples, x, y);
      CHECK(int(picture.at(x, y).g) == byte);
    }
  }
}

TEST_CASE("colours at a triangle's rim are its own: nothing is extrapolated") {
  // Slivers whose colours rise from 1/4 to 3/4 within a fraction of a pixel: 64 and 191 as bytes.
  Mesh mesh;
  Random random(6);
  for (int i = 0; i < 400; ++i) {
    const float x = float(random.between(0, kSamplesSide)),
                y = float(random.between(0, kSamplesSide));
    const auto near = [&](float v) { return v + float(random.between(-0.7, 0.7)); };
    const auto first = std::uint32_t(mesh.positions.size());
    for (int k = 0; k < 3; ++k) {
      const auto at_x = near(x), at_y = near(y);
      mesh.positions.push_back(at_pixel(at_x, at_y, float(random.between(0.5, 5))));
      const auto shade = float(random.integer(0, 1) == 0 ? 0.25 : 0.75);
      mesh.colors.push_back({shade, shade, shade, 1});
    }
    test::add_face(mesh, {first, first + 1, first + 2});
    for (std::uint32_t k = 0; k < 3; ++k) mesh.corners[first + k].color = first + k;
  }
  const Scene scene = test::scene_of(mesh, white());
  std::size_t mixed = 0;
  for (const int samples : kCounts) {
    RenderSettings settings = plain(samples);
    settings.background = {128, 128, 128, 255};
    const Image<Rgba8> picture = picture_of(scene, settings);
    for (const Rgba8& color : picture.pixels) {
      CHECK(color.g >= 64);
      CHECK(color.g <= 191);
      mixed += color.g != 128;
    }
  }
  CHECK(mixed > 400);
}

TEST_CASE("pixels wholly inside a triangle look as with one sample") {
  // One textured and lit triangle over the whole picture.
  const Scene checker = *make_builtin("checker");
  Mesh mesh;
  mesh.positions = {{-40, -30, -9}, {45, -35, -12}, {2, 70, -20}};
  mesh.texcoords = {{0, 0}, {7, 1}, {2, 9}};
  test::add_face(mesh, {0, 1, 2});
  for (std::uint32_t k = 0; k < 3; ++k) mesh.corners[k].texcoord = k;
  Scene scene = test::scene_of(mesh);
  scene.images = checker.images;
  scene.textures = checker.textures;
  scene.materials[0].texture = 0;
  scene.materials[0].specular = {0.5f, 0.5f, 0.5f};
  const View view = *make_view({"front", PerspectiveLens{1.0, 0.1, {}}, {}}, 70, 50);
  const Image<Rgba8> one = render_staged(scene, view, {}).buffers.color;
  CHECK(one.at(0, 0) != one.at(69, 49));
  for (const int samples : kCounts) {
    RenderSettings settings;
    settings.samples = samples;
    CHECK(render_staged(scene, view, settings).buffers.color.pixels == one.pixels);
    test::check_same(scene, view, settings, {2, 16});
  }
}

TEST_CASE("all planes but the colours are those of one sample, and so are pictures of planes") {
  Random random(12);
  std::size_t colors_differ = 0;
  for (int i = 0; i < 150; ++i) {
    test::GeneratedCase c = test::generate_case(random, 60, 60);
    c.settings.want_distance = c.settings.want_id = true;
    c.settings.samples = 1;
    const Framebuffer one = render_staged(c.scene, c.view, c.settings).buffers;
    c.settings.samples = kCounts[std::size_t(i % 4)];
    Framebuffer several = render_staged(c.scene, c.view, c.settings).buffers;
    CHECK(several.samples.empty());
    colors_differ += several.color.pixels != one.color.pixels;
    const Show show = c.settings.show;
    if (show != Show::kDepth && show != Show::kId && show != Show::kOverdraw) {
      several.color = one.color;
    }
    INFO("case " << i << "\n" << test::in_words(c));
    CHECK(test::planes_differ(one, several, true) == "");
  }
  CHECK(colors_differ > 50);
}

TEST_CASE("both engines draw the same samples, for threads, targets, tiles and rounds") {
  for (const char* name : {"forest", "room"}) {
    const Scene scene = *make_builtin(name);
    const View view = *make_view(test::camera_for(scene, 1.5), 90, 60);
    for (const int samples : kCounts) {
      RenderSettings settings;
      settings.samples = samples;
      settings.want_depth = settings.want_distance = settings.want_id = true;
      const Rendering staged = render_staged(scene, view, settings);
      CHECK(staged.statistics.covered == staged.statistics.depth_failed +
                                             staged.statistics.discarded +
                                             staged.statistics.written);
      std::vector<TileOptions> ways{{1, 64}, {3, 16}, {2, 256}, {2, 32, best_target(), false}};
      ways.push_back({2, 64, best_target(), true, 300});  // drawn in several rounds
      for (const Target target : available_targets()) ways.push_back({2, 64, target});
      for (const TileOptions& way : ways) {
        CAPTURE(name, samples, way.threads, way.tile_side, way.round_size);
        const Rendering tiled = render_tiled(scene, view, settings, way);
        test::check_same_planes(staged.buffers, tiled.buffers);
        test::check_same_counts(staged.statistics, tiled.statistics);
        CHECK(tiled.buffers.samples.empty());
      }
    }
  }
}

TEST_CASE("an engine draws one sample after several, and several after one, in the same memory") {
  const Scene scene = *make_builtin("room");
  const View view = *make_view(test::camera_for(scene, 1.5), 90, 60);
  Renderer renderer(scene, Transfer::kSrgb, EngineKind::kTile, {2, 32});
  for (const int samples : {4, 1, 16, 2, 1}) {
    RenderSettings settings;
    settings.samples = samples;
    CHECK(renderer.render(view, settings).buffers.color.pixels ==
          render_staged(scene, view, settings).buffers.color.pixels);
  }
}

TEST_CASE("each eye of a pair has its samples, and an anaglyph's eyes share the picture (S0-05)") {
  for (PairCase& c : pair_cases()) {
    INFO(c.name);
    for (Material& material : c.scene.materials) {
      if (c.name == "room") material.alpha_mode = AlphaMode::kBlend, material.base_color.a = 0.5f;
    }
    StereoSettings settings;
    settings.render.samples = 4;
    const StereoRendering both = render_pair(c.scene, c.centre, c.pair, settings);
    const View left = eye_view(c.centre, c.pair, Side::kLeft);
    CHECK(both.left.color.pixels ==
          render_staged(c.scene, left, settings.render).buffers.color.pixels);
    const StereoRendering masked = render_masked_anaglyph(c.scene, c.centre, c.pair, settings, {});
    std::size_t differing = 0;
    for (std::size_t i = 0; i < masked.left.color.pixels.size(); ++i) {
      const Rgba8 l = both.left.color.pixels[i], r = both.right.color.pixels[i];
      differing += !(masked.left.color.pixels[i] == Rgba8{l.r, r.g, r.b, r.a});
    }
    CHECK(differing == 0);
    for (const std::size_t round : {std::size_t{1} << 23, std::size_t{200}}) {
      Renderer tiles(c.scene, Transfer::kSrgb, EngineKind::kTile,
                     {2, 32, best_target(), true, round});
      const StereoRendering tiled = tiles.render_pair(c.centre, c.pair, settings);
      test::check_same_planes(both.left, tiled.left, false);
      test::check_same_planes(both.right, tiled.right, false);
      const StereoRendering one = tiles.render_masked_anaglyph(c.centre, c.pair, settings, {});
      CHECK(one.left.color.pixels == masked.left.color.pixels);
    }
  }
}

}  // namespace glassbox
