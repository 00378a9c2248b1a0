// Both eyes from one run give the same bytes as two runs, no matter what they share.
#include <array>
#include <string>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/render/renderer.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/staged/vertex_stage.h>
#include <glassbox/render/stereo/render_pair.h>

#include "tests/render/stereo/pairs.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

// The red channel of one picture and the other channels of another (S0-02), written without the
// library's masks.
Image<Rgba8> red_cyan(const Image<Rgba8>& left, const Image<Rgba8>& right) {
  Image<Rgba8> anaglyph = right;
  for (std::size_t i = 0; i < anaglyph.pixels.size(); ++i) anaglyph.pixels[i].r = left.pixels[i].r;
  return anaglyph;
}

std::size_t differing_pixels(const Image<Rgba8>& a, const Image<Rgba8>& b) {
  REQUIRE(a.pixels.size() == b.pixels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) count += !(a.pixels[i] == b.pixels[i]);
  return count;
}

// The staged renderer, and the tile engine with one tile and with many.
std::vector<Renderer> many_renderers(const Scene& scene) {
  std::vector<Renderer> all;
  all.emplace_back(scene, Transfer::kSrgb, EngineKind::kStaged);
  all.emplace_back(scene, Transfer::kSrgb, EngineKind::kTile,
                   TileOptions{.threads = 1, .tile_side = 128});
  all.emplace_back(
      scene, Transfer::kSrgb, EngineKind::kTile,
      TileOptions{.threads = 3, .tile_side = 16, .target = Target::kScalar, .plan = false});
  return all;
}

std::vector<RenderSettings> many_settings() {
  std::vector<RenderSettings> all;
  for (const Shading shading :
       {Shading::kUnlit, Shading::kFlat, Shading::kGouraud, Shading::kPhong}) {
    all.push_back({});
    all.back().shading = shading;
  }
  for (const Show show : {Show::kDepth, Show::kNormal, Show::kUv, Show::kId, Show::kOverdraw}) {
    all.push_back({});
    all.back().show = show;
  }
  all.push_back({});
  all.back().wireframe = true;
  all.push_back({});
  all.back().cull = Cull::kNone;
  return all;
}

}  // namespace

TEST_CASE("each eye's picture is the one that a run of its own makes (S0-03)") {
  for (const PairCase& c : pair_cases()) {
    std::vector<Renderer> renderers = many_renderers(c.scene);
    for (RenderSettings settings : many_settings()) {
      settings.want_depth = settings.want_distance = settings.want_id = true;
      const auto own = [&](Side side) {
        return render_staged(c.scene, eye_view(c.centre, c.pair, side), settings).buffers;
      };
      INFO(c.name << ", shading " << int(settings.shading) << ", show " << int(settings.show));
      const Framebuffer left = own(Side::kLeft), right = own(Side::kRight);
      for (Renderer& renderer : renderers) {
        INFO("renderer " << &renderer - renderers.data());
        const StereoRendering both = renderer.render_pair(c.centre, c.pair, {settings});
        CHECK(both.left.color == left.color);
        CHECK(both.left.depth == left.depth);
        CHECK(both.left.distance == left.distance);
        CHECK(both.left.id == left.id);
        CHECK(both.right.color == right.color);
        CHECK(both.right.depth == right.depth);
        CHECK(both.right.distance == right.distance);
        CHECK(both.right.id == right.id);
      }
    }
  }
}

TEST_CASE(
    "the object stage is run once; y, z and w of both eyes are the same bits (S0-03, S0-07)") {
  for (const PairCase& c : pair_cases()) {
    INFO(c.name);
    const Statistics mono = render_staged(c.scene, c.centre, {}).statistics;
    for (Renderer& renderer : many_renderers(c.scene)) {
      const StereoRendering both = renderer.render_pair(c.centre, c.pair, {});
      CHECK(both.passes == 2);
      // The plan leaves out draws that neither eye sees.
      const bool all = both.left_statistics.left_out == 0;
      CHECK((all ? both.left_statistics.vertices == mono.vertices
                 : both.left_statistics.vertices < mono.vertices));
      CHECK(both.right_statistics.vertices == 0);
      CHECK(both.right_statistics.moved_in_x == both.left_statistics.vertices);
    }

    const View left = eye_view(c.centre, c.pair, Side::kLeft);
    const View right = eye_view(c.centre, c.pair, Side::kRight);
    const PreparedScene prepared = prepare_scene(c.scene, Transfer::kSrgb);
    const DrawList list = make_draw_list(c.scene, prepared, left);
    const std::vector<Draw> others = draws_of_other_eye(list.draws, right);
    const DrawList own = make_draw_list(c.scene, prepared, right);
    for (std::size_t i = 0; i < list.draws.size(); ++i) {
      CHECK(others[i].clip_from_anchored == own.draws[i].clip_from_anchored);
      const ClipTable first = project_vertices(list.draws[i], left);
      const ClipTable shared = project_other_eye(others[i], right, first);
      const ClipTable anew = project_vertices(own.draws[i], right);
      CHECK(shared.positions == anew.positions);
      CHECK(shared.outcodes == anew.outcodes);
    }
  }
}

TEST_CASE("the anaglyph of two masks is the two pictures put together by channel (S0-02, S0-05)") {
  for (const PairCase& c : pair_cases()) {
    std::vector<Renderer> renderers = many_renderers(c.scene);
    for (const RenderSettings& settings : many_settings()) {
      INFO(c.name << ", shading " << int(settings.shading) << ", show " << int(settings.show));
      const StereoRendering both = render_pair(c.scene, c.centre, c.pair, {settings});
      const Image<Rgba8> expected = red_cyan(both.left.color, both.right.color);
      for (Renderer& renderer : renderers) {
        INFO("renderer " << &renderer - renderers.data());
        const StereoRendering masked =
            renderer.render_masked_anaglyph(c.centre, c.pair, {settings}, {});
        CHECK(masked.left.color == expected);
        CHECK(masked.right.color.pixels.empty());
      }
    }
  }
}

enum class Beside { kLeft, kRight, kAbove, kBelow };

// A triangle that an orthographic view of 16 x 16 pixels would show `beside_px` outside its
// picture, then moved to the right by `moved_px`.
Scene beside_the_picture(Beside where, float beside_px, float distance = 5, float moved_px = 0) {
  Scene scene;
  scene.name = "beside";
  scene.nodes = {Node{"root", kNone, {}, {}}};
  scene.materials = {{}};
  scene.instances = {Instance{0, 0}};
  Mesh mesh;
  const float sign = where == Beside::kLeft || where == Beside::kBelow ? -1.0f : 1.0f;
  const bool along_x = where == Beside::kAbove || where == Beside::kBelow;
  const float edge = sign * (8 + beside_px);
  for (const auto& [out, along] : {std::pair{edge, -4.0f}, {edge, 4.0f}, {edge + sign * 4, 0.0f}}) {
    mesh.positions.push_back(
        {(along_x ? along : out) + moved_px, along_x ? out : along, -distance});
  }
  mesh.faces = {{0, 3}};
  mesh.corners = {Corner{0}, Corner{1}, Corner{2}};
  scene.meshes = {mesh};
  return scene;
}

// A view of 16 x 16 pixels, one per unit. Both eyes see a point at the window's distance, 5, at the
// same place.
PairCase pair_of_wireframes(Scene scene) {
  PairCase c{"beside", std::move(scene), {}, {}, 16, 16};
  c.centre = *make_view({"front", OrthographicLens{8, 0.1, 100}, {}}, c.width, c.height);
  c.pair = {1, 5};
  REQUIRE(check_pair(c.centre, c.pair));
  return c;
}

RenderSettings wireframe(int samples) {
  RenderSettings settings;
  settings.wireframe = true;
  settings.samples = samples;
  settings.cull = Cull::kNone;
  return settings;
}

// Checks both eyes' pictures by all renderers. Returns how many pixels are drawn.
std::size_t check_wireframes(const PairCase& c, const StereoSettings& settings) {
  const auto own = [&](Side side) {
    return render_staged(c.scene, eye_view(c.centre, c.pair, side), settings.render).buffers.color;
  };
  const Image<Rgba8> left = own(Side::kLeft), right = own(Side::kRight);
  for (Renderer& renderer : many_renderers(c.scene)) {
    INFO("renderer for " << c.name);
    const StereoRendering both = renderer.render_pair(c.centre, c.pair, settings);
    CHECK(both.left.color == left);
    CHECK(both.right.color == right);
    CHECK(both.lost == 0);
  }
  const Image<Rgba8> empty(c.width, c.height, settings.render.background);
  return differing_pixels(left, empty) + differing_pixels(right, empty);
}

constexpr std::array kAllSides{Beside::kLeft, Beside::kRight, Beside::kAbove, Beside::kBelow};

TEST_CASE("the lines of a wireframe reach into both eyes' pictures from beside them") {
  for (const StereoCulling culling : {StereoCulling::kUnion, StereoCulling::kCentre}) {
    int drawn_at_centres = 0;
    for (const Beside where : kAllSides) {
      INFO("culling " << int(culling) << ", side " << int(where));
      const StereoSettings of_samples{wireframe(8), culling};
      CHECK(check_wireframes(pair_of_wireframes(beside_the_picture(where, 0.25f)), of_samples) > 0);
      // Snapped onto the border, where a line belongs to the pixels on one side of it.
      const StereoSettings of_centres{wireframe(1), culling};
      drawn_at_centres +=
          check_wireframes(pair_of_wireframes(beside_the_picture(where, 0x1p-10f)), of_centres) > 0;
      const PairCase farther = pair_of_wireframes(beside_the_picture(where, 2));
      CHECK(render_pair(farther.scene, farther.centre, farther.pair, of_samples).culled == 1);
    }
    CHECK(drawn_at_centres >= 2);
  }
}

TEST_CASE("a line that reaches into one eye's picture alone is drawn there") {
  constexpr float kDistance = 10;  // behind the window
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const Beside where : {Beside::kLeft, Beside::kRight}) {
      INFO("eye " << int(side) << ", side " << int(where));
      const PairCase any = pair_of_wireframes({});
      const View eye = eye_view(any.centre, any.pair, side);
      const Transform<Clip, Eye>& clip = eye.clip_from_eye;
      const Point<Eye, double> middle =
          eye.eye_from_world * Point<World, double>(0, 0, -double(kDistance));
      const double ndc = clip.at(0, 0) * middle.x + clip.at(0, 2) * middle.z + clip.at(0, 3);
      const auto moved_px = float(-8 * ndc);
      REQUIRE(std::abs(moved_px) >= 0.9f);  // in the other eye's picture it is twice as far outside
      const PairCase c = pair_of_wireframes(beside_the_picture(where, 0.25f, kDistance, moved_px));
      CHECK(check_wireframes(c, {wireframe(8), StereoCulling::kUnion}) > 0);
    }
  }
}

TEST_CASE("channels that both eyes may write are the right one's, alpha before a background too") {
  PairCase c = pair_case("cube", 0.03);
  for (Material& material : c.scene.materials) {
    material.alpha_mode = AlphaMode::kBlend;
    material.base_color.a = 0.3f;
  }
  c.scene.instances.push_back(c.scene.instances.front());  // blended a second time
  RenderSettings settings;
  settings.background = {26, 31, 38, 60};
  settings.cull = Cull::kNone;
  const AnaglyphMasks masks{{true, true, true, true}, {false, true, true, true}};
  for (const int samples : {1, 4}) {
    settings.samples = samples;
    INFO("samples " << samples);
    const StereoRendering both = render_pair(c.scene, c.centre, c.pair, {settings});
    const Image<Rgba8> expected = red_cyan(both.left.color, both.right.color);
    for (Renderer& renderer : many_renderers(c.scene)) {
      CHECK(renderer.render_masked_anaglyph(c.centre, c.pair, {settings}, masks).left.color ==
            expected);
    }
  }
}

TEST_CASE("a depth buffer that is not cleared between the eyes shows in the right eye (C-76)") {
  const PairCase c = pair_cases().front();
  const StereoRendering right_way = render_masked_anaglyph(c.scene, c.centre, c.pair, {}, {});

  const View left = eye_view(c.centre, c.pair, Side::kLeft);
  const View right = eye_view(c.centre, c.pair, Side::kRight);
  RenderSettings red, cyan;
  red.mask = {true, false, false, false};
  cyan.mask = {false, true, true, true};
  const PreparedScene prepared = prepare_scene(c.scene, Transfer::kSrgb);
  Framebuffer of_left, of_right;
  Statistics statistics;
  StagedEngine engine;
  const EyePicture first{left, red, of_left, of_left.color, statistics};
  engine.draw({c.scene, prepared, {&first, 1}});

  SECTION("cleared, two passes after each other are the masked anaglyph") {
    const EyePicture second{right, cyan, of_right, of_left.color, statistics};
    engine.draw({c.scene, prepared, {&second, 1}});
    CHECK(of_left.color == right_way.left.color);
  }
  SECTION("not cleared, the left eye's silhouettes hide the right eye's picture") {
    struct DepthLeft : Observer {
      explicit DepthLeft(const Image<std::uint32_t>& codes) : left(codes) {}
      void compared(const FragmentSource&, const Fragment& fragment, std::uint32_t code,
                    std::uint32_t, bool& in_front) override {
        in_front = in_front && glassbox::in_front(code, left.at(fragment.x, fragment.y));
      }
      const Image<std::uint32_t>& left;
    } kept(of_left.depth);
    const EyePicture second{right, cyan, of_right, of_left.color, statistics, &kept};
    engine.draw({c.scene, prepared, {&second, 1}});
    CHECK(differing_pixels(of_left.color, right_way.left.color) > 0);
  }
  SECTION("with the colours cleared too, the left eye's picture is gone") {
    const EyePicture second{right, cyan, of_right, of_right.color, statistics};
    engine.draw({c.scene, prepared, {&second, 1}});
    CHECK(differing_pixels(of_right.color, right_way.left.color) > 0);
  }
}

TEST_CASE("zero separation takes one pass and gives the mono bytes (C-71)") {
  for (PairCase& c : pair_cases()) {
    INFO(c.name);
    c.pair.half_separation = 0;
    const Image<Rgba8> mono = render_staged(c.scene, c.centre, {}).buffers.color;
    for (Renderer& renderer : many_renderers(c.scene)) {
      const StereoRendering both = renderer.render_pair(c.centre, c.pair, {});
      CHECK(both.passes == 1);
      CHECK(both.left.color == mono);
      CHECK(both.right.color == mono);
      const StereoRendering masked = renderer.render_masked_anaglyph(c.centre, c.pair, {}, {});
      CHECK(masked.passes == 1);
      CHECK(masked.left.color == mono);
    }
  }
}

TEST_CASE(
    "culling by the centre camera loses what only a skewed frustum sees, at the edges (S0-04, "
    "E20)") {
  std::vector<PairCase> cases = pair_cases();
  cases.push_back(pair_case("forest", 0.05, 320, 180));
  std::size_t lost_pixels = 0;
  for (const PairCase& c : cases) {
    INFO(c.name << ", " << c.width << " x " << c.height);
    RenderSettings settings;
    settings.want_distance = true;
    const StereoRendering all = render_pair(c.scene, c.centre, c.pair, {settings});
    CHECK(all.lost == 0);
    const StereoRendering centre =
        render_pair(c.scene, c.centre, c.pair, {settings, StereoCulling::kCentre});
    if (centre.lost == 0) {
      CHECK(centre.left.color == all.left.color);
      CHECK(centre.right.color == all.right.color);
      continue;
    }
    // A triangle outside the centre's frustum reaches into an eye's picture by at most half its
    // parallax; what appears in its place may be elsewhere. One pixel is added for the rounding to
    // pixel centres.
    const auto check_strips = [&](const Framebuffer& kept, const Framebuffer& lossy) {
      for (int y = 0; y < c.height; ++y) {
        for (int x = 0; x < c.width; ++x) {
          if (kept.color.at(x, y) == lossy.color.at(x, y)) continue;
          ++lost_pixels;
          const double z = double(kept.distance.at(x, y));
          const double strip = std::abs(parallax_at(c.centre, c.pair, z).px) / 2;
          CHECK(std::min(x, c.width - 1 - x) <= strip + 1);
        }
      }
    };
    check_strips(all.left, centre.left);
    check_strips(all.right, centre.right);
  }
  CHECK(lost_pixels > 0);  // otherwise nothing was compared
}

}  // namespace glassbox
