// A right eye that is warped from the layers of the left one (S0-06, S1-09).
#include <algorithm>
#include <cmath>
#include <vector>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/stereo/parallax.h>

#include "tests/support/catch.h"
#include "views/layers/depth_peeling.h"
#include "views/layers/second_eye_error.h"

using namespace glassbox;
using namespace glassbox::views;

namespace {

constexpr float kInfinitelyFar = std::numeric_limits<float>::infinity();

// A perspective view of 100 x 10 pixels with a focal length of 100 px.
View flat_view(double near = 1) {
  Camera camera;
  camera.lens = PerspectiveLens{2 * std::atan(0.05), near, 100.0};
  return make_view(camera, 100, 10).value();
}

// Stripes in which every column has its own colour.
Image<Rgba8> striped(int width, int height) {
  Image<Rgba8> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      picture.at(x, y) = {std::uint8_t(2 * x), std::uint8_t(255 - 2 * x), std::uint8_t(y)};
  }
  return picture;
}

struct WarpedEye {
  Image<Rgba8> color;
  std::size_t holes = 0;
};

// The depth codes that the rasterizer stores for distances along the gaze.
Image<std::uint32_t> codes(const View& view, const Image<float>& distance,
                           DepthFormat format = DepthFormat::kFloat32) {
  Image<std::uint32_t> depth(distance.width, distance.height, kEmptyDepth);
  for (std::size_t i = 0; i < distance.pixels.size(); ++i) {
    if (!std::isfinite(distance.pixels[i])) continue;
    const auto clip = view.clip_from_eye * Point<Eye, double>{0, 0, -double(distance.pixels[i])};
    depth.pixels[i] = depth_code(format, float(clip.z / clip.w));
  }
  return depth;
}

WarpedEye warped(const Image<Rgba8>& color, const Image<float>& distance, const View& view,
                 const StereoPair& pair, const SecondEyeSettings& settings = {}) {
  WarpedEye eye;
  const Image<std::uint32_t> depth = codes(view, distance, settings.format);
  const LayerView layer{color, depth};
  eye.holes = SecondEye().warp(layer, view, pair, settings, eye.color);
  return eye;
}

// The right eye warped from several layers, the first of which is in front.
WarpedEye warped(const std::vector<LayerView>& layers, const View& view, const StereoPair& pair,
                 const SecondEyeSettings& settings = {}) {
  WarpedEye eye;
  SecondEye second;
  second.begin(layers[0], view, pair, settings);
  for (std::size_t i = 1; i < layers.size(); ++i) second.add(layers[i]);
  eye.holes = second.finish(eye.color);
  return eye;
}

struct Stage {
  Scene scene;
  View view;
  StereoPair pair;
};
Stage stage_of(const char* name, int width, int height, const StereoPair& pair) {
  Scene scene = make_builtin(name).value();
  const Camera camera = scene.cameras.empty()
                            ? framing_camera(scene, double(width) / height).value()
                            : scene.cameras[0];
  const View view = make_view(camera, width, height).value();
  return {std::move(scene), view, pair};
}

}  // namespace

TEST_CASE("what is at the window has no parallax: the right picture is the left one") {
  const Image<Rgba8> color = striped(100, 10);
  const WarpedEye eye = warped(color, Image<float>(100, 10, 4.0f), flat_view(), {0.1, 4});
  CHECK(eye.holes == 0);
  CHECK(eye.color.pixels == color.pixels);
}

TEST_CASE(
    "a wall behind the window moves to the right by its parallax, and what comes in is filled") {
  const Image<Rgba8> color = striped(100, 10);
  // The parallax is 2 s (W/2) a (1/f - 1/z) = 100 px 0.2 (1/2 - 1/4) = 5 px.
  const WarpedEye eye = warped(color, Image<float>(100, 10, 4.0f), flat_view(), {0.1, 2});
  CHECK(eye.holes == 5 * 10);
  for (int x = 5; x < 100; ++x) REQUIRE(eye.color.at(x, 3) == color.at(x - 5, 3));
  for (int x = 0; x < 5; ++x) CHECK(eye.color.at(x, 3) == color.at(0, 3));
}

TEST_CASE("every way to store a depth moves a wall alike, to the parallax of its last place") {
  const Image<Rgba8> color = striped(100, 10);
  const Image<float> wall(100, 10, 4.0f);
  for (const DepthFormat format : {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                   DepthFormat::kUnorm24, DepthFormat::kUnorm16}) {
    const bool reversed = format == DepthFormat::kFloat32Reversed;
    Camera camera;
    camera.lens = PerspectiveLens{2 * std::atan(0.05), 1, 100.0};
    const View view =
        make_view(camera, 100, 10, reversed ? DepthRange::kReversed : DepthRange::kStandard)
            .value();
    const WarpedEye eye = warped(color, wall, view, {0.1, 2}, {.format = format});
    INFO(int(format));
    // 5 px; in 16 bits within 20 px / 65535, which is less than the 256 steps of interpolation
    // between columns resolve.
    for (int x = 6; x < 99; ++x) CHECK(std::abs(eye.color.at(x, 3).r - 2 * (x - 5)) <= 1);
  }
}

TEST_CASE("between pixels there is a mixture of both") {
  const Image<Rgba8> color = striped(100, 10);
  // A parallax of 2.5 px.
  const WarpedEye eye = warped(color, Image<float>(100, 10, 4.0f), flat_view(), {0.05, 2});
  for (int x = 3; x < 100; ++x) {
    // Half of 2 (x - 3) and half of 2 (x - 2).
    CHECK(int(eye.color.at(x, 0).r) == 2 * x - 5);
  }
}

TEST_CASE(
    "beside a card the holes are (W/2)(d/h) B (1/z_front - 1/z_back) wide, and the wall fills "
    "them") {
  Image<Rgba8> color(100, 10, {200, 0, 0});
  Image<float> distance(100, 10, 8.0f);
  for (int y = 0; y < 10; ++y) {
    for (int x = 40; x < 60; ++x) {
      color.at(x, y) = {0, 0, 200};
      distance.at(x, y) = 2;
    }
  }
  const StereoPair pair{0.1, 4};
  const WarpedEye eye = warped(color, distance, flat_view(), pair);
  // 100 px 0.2 (1/2 - 1/8) = 7.5 px beside the card, and 100 px 0.2 (1/4 - 1/8) = 2.5 px at the
  // left edge.
  CHECK(double(eye.holes) / 10 == Approx(7.5 + 2.5).margin(1));
  // The card is 5 px further to the left; the rest is wall.
  for (int x = 0; x < 100; ++x) {
    const bool card = x >= 35 && x < 55;
    CHECK(eye.color.at(x, 5) == (card ? Rgba8{0, 0, 200} : Rgba8{200, 0, 0}));
  }
}

TEST_CASE("what a second layer has behind the first one fills the holes with what is there") {
  Image<Rgba8> front(100, 10, {200, 0, 0}), back(100, 10, {0, 0, 0});
  Image<float> near(100, 10, 8.0f), far(100, 10, kInfinitelyFar);
  for (int y = 0; y < 10; ++y) {
    for (int x = 40; x < 60; ++x) {
      front.at(x, y) = {0, 0, 200};
      near.at(x, y) = 2;
      back.at(x, y) = {std::uint8_t(100 + x), 0, 0};  // the wall behind the card
      far.at(x, y) = 8;
    }
  }
  const Image<std::uint32_t> front_depth = codes(flat_view(), near),
                             back_depth = codes(flat_view(), far);
  const std::vector<LayerView> layers{{front, front_depth}, {back, back_depth}};
  const WarpedEye one = warped({layers[0]}, flat_view(), {0.1, 4});
  const WarpedEye two = warped(layers, flat_view(), {0.1, 4});
  CHECK(one.holes >= 90);
  CHECK(two.holes <= 30);  // the strip at the left edge
  CHECK(int(two.color.at(58, 5).r) > 140);
  CHECK(int(two.color.at(58, 5).r) < 160);
  CHECK(two.color.at(45, 5) == Rgba8{0, 0, 200});
}

TEST_CASE("the warped eye depends on neither threads nor target") {
  const Stage stage = stage_of("room", 203, 61, {0.05, 3});
  RenderSettings settings;
  settings.want_distance = true;
  const std::vector<Layer> layers =
      peel(stage.scene, eye_view(stage.view, stage.pair, Side::kLeft), settings, 3);
  std::vector<LayerView> views;
  for (const Layer& layer : layers) views.push_back({layer.color, layer.depth});
  const WarpedEye plainly = warped(views, stage.view, stage.pair, {3, 1, Target::kScalar});
  for (const Target target : available_targets()) {
    for (const int threads : {1, 2, 100}) {
      const WarpedEye eye = warped(views, stage.view, stage.pair, {3, threads, target});
      INFO(name_of(target) << ", " << threads);
      CHECK(eye.color.pixels == plainly.color.pixels);
      CHECK(eye.holes == plainly.holes);
    }
  }
}

TEST_CASE(
    "a row to which nothing comes shows the first eye's left edge, whatever was drawn before") {
  const Image<Rgba8> color = striped(100, 64);
  Camera camera;
  camera.lens = PerspectiveLens{2 * std::atan(0.32), 1, 100.0};
  const View view = make_view(camera, 100, 64).value();
  const Image<std::uint32_t> nothing(100, 64, kEmptyDepth);
  for (const Target target : available_targets()) {
    for (const int threads : {1, 3}) {
      INFO(name_of(target) << ", " << threads);
      SecondEye second;
      Image<Rgba8> right;
      const Image<Rgba8> other(100, 64, {1, 2, 3});
      second.warp({other, nothing}, view, {0.1, 4}, {1, threads, target}, right);
      // Infinity moves by 2 s 100 px / window = 100 px, the width of the picture.
      CHECK(second.warp({color, nothing}, view, {2, 4}, {1, threads, target}, right) == 6400);
      for (int y = 0; y < 64; ++y) REQUIRE(std::ranges::count(right.pixels, color.at(0, y)) == 100);
    }
  }
}

// Translucent surfaces store no depth, so in front of the background their pixels look empty.
TEST_CASE("what is seen through before the background keeps its colours in the warped eye") {
  constexpr int kWidth = 200;
  const Rgba8 background{20, 30, 40}, pane{120, 90, 40};
  Image<Rgba8> color(kWidth, 10, background);
  const Image<float> nothing(kWidth, 10, kInfinitelyFar);
  // A pane of one colour, a pane that changes from pixel to pixel, and a single pixel.
  for (int y = 0; y < 10; ++y) {
    for (int x = 60; x < 130; ++x) color.at(x, y) = x < 90 ? pane : Rgba8{std::uint8_t(x), 0, 100};
    color.at(160, y) = pane;
  }
  Camera camera;
  camera.lens = PerspectiveLens{2 * std::atan(0.05), 1, 100.0};
  const View wide = make_view(camera, kWidth, 10).value();
  // The background is infinitely far away: 2 s f / window = 0.2 * 100 px / 4 = 5 px to the right.
  for (const Target target : available_targets()) {
    INFO(name_of(target));
    const WarpedEye eye = warped(color, nothing, wide, {0.1, 4}, {.target = target});
    CHECK(eye.holes == 5 * 10);
    for (int x = 5; x < kWidth; ++x) {
      INFO(x);
      REQUIRE(eye.color.at(x, 3) == color.at(x - 5, 3));
    }
  }
}

TEST_CASE("glass before the background is seen by both eyes, with glass before a wall beside it") {
  Scene scene;
  scene.nodes = {Node{"root", kNone, {}, {}}};
  Material glass;
  glass.alpha_mode = AlphaMode::kBlend;
  glass.base_color = {1, 0, 0, 0.5f};
  glass.unlit = true;
  Material paint;
  paint.base_color = {0, 0, 1, 1};
  paint.unlit = true;
  scene.materials = {paint, glass};
  const auto add_card = [&](std::uint32_t material, float left, float right, float distance) {
    Mesh mesh;
    mesh.material = material;
    for (const auto& [x, y] : {std::pair{left, -1.0f}, {right, -1.0f}, {right, 1.0f}, {left, 1.0f}})
      mesh.positions.push_back({x, y, -distance});
    mesh.faces.push_back({0, 4});
    for (std::uint32_t i = 0; i < 4; ++i) mesh.corners.push_back({i});
    scene.instances.push_back({std::uint32_t(scene.meshes.size()), 0});
    scene.meshes.push_back(std::move(mesh));
  };
  add_card(0, 0.5f, 5, 6);      // the wall, in the right half of the picture
  add_card(1, -1.5f, 1.5f, 4);  // the glass, in the middle
  const Camera camera{"front", PerspectiveLens{1.0, 1, 50.0}, {}};
  constexpr int kRows = 180;
  const View view = make_view(camera, 320, kRows).value();
  RenderSettings settings;
  settings.background = {0, 60, 0, 255};
  const StereoPair eyes{0.05, 4};
  const auto count_of = [](const Image<Rgba8>& picture, const Rgba8& color) {
    return std::ranges::count(picture.pixels, color);
  };
  for (const Target target : available_targets()) {
    INFO(name_of(target));
    Renderer renderer(scene, Transfer::kNone, EngineKind::kTile, {.target = target});
    settings.transfer = Transfer::kNone;
    SecondEye second;
    WarpedPair both;
    render_pair_by_warp(renderer, view, eyes, settings, {.target = target}, second, both);
    const Image<Rgba8>&left = both.rendering.left.color, &right = both.rendering.right.color;
    for (const Rgba8& color : {Rgba8{128, 30, 0, 255}, Rgba8{128, 0, 128, 255}}) {
      const auto in_left = count_of(left, color), in_right = count_of(right, color);
      INFO(in_left << " pixels in the left eye, " << in_right << " in the right one");
      CHECK(in_left > 1000);
      // An edge moves by less than 5 px (0.1 * 165 px / 4), and the pixel at each of the two edges
      // may be interpolated.
      CHECK(std::abs(in_left - in_right) <= kRows * (5 + 2));
    }
  }
}

namespace {

// The errors of a right eye from 1, 2 and 4 layers.
std::vector<SecondEyeError> errors_by_layers(const Stage& stage) {
  Renderer renderer(stage.scene, Transfer::kSrgb, EngineKind::kTile, {.threads = 1});
  std::vector<SecondEyeError> errors;
  for (const int layers : {1, 2, 4}) {
    errors.push_back(second_eye_error(renderer, stage.view, stage.pair, {}, {.layers = layers}));
    const SecondEyeError& error = errors.back();
    UNSCOPED_INFO(layers << " layers: " << error.warped.wrong << " of " << error.pixels
                         << " wrong, " << error.left.wrong << " of the left picture, "
                         << error.holes << " holes");
    CHECK(error.pixels == 480 * 270);
    CHECK(error.warped.rms < error.left.rms);
  }
  CHECK(errors[1].holes < errors[0].holes);
  CHECK(errors[2].holes <= errors[1].holes);
  return errors;
}

}  // namespace

// The eyes are those that `render` chooses. In a room that is closed by walls, edges remain wrong:
// a picture without interpolated pixels has them up to a pixel away.
TEST_CASE("warped, a room's right eye is wrong in a ninth of the pixels of the left picture's") {
  const auto errors =
      errors_by_layers(stage_of("room", 480, 270, {0.0663731669793334, 3.982390018760004}));
  CHECK(errors[0].warped.wrong * 9 < errors[0].left.wrong);
  CHECK(errors[1].warped.wrong <= errors[0].warped.wrong);
  CHECK(errors[1].holes * 20 < errors[0].holes);
}

TEST_CASE("in a forest a second layer knows better than what is beside a hole") {
  const auto errors =
      errors_by_layers(stage_of("forest", 480, 270, {0.08330003509376358, 36.46944165412449}));
  CHECK(errors[0].warped.wrong * 8 < errors[0].left.wrong);
  CHECK(errors[1].warped.wrong * 3 < errors[0].warped.wrong * 2);
  CHECK(errors[2].warped.wrong <= errors[1].warped.wrong);
}

TEST_CASE("a parallel view's second eye is warped by the parallax that it has") {
  Camera camera;
  camera.lens = OrthographicLens{1, 1, 9};
  const View view = make_view(camera, 100, 10).value();
  const StereoPair pair{0.01, 5};
  const Image<Rgba8> color = striped(100, 10);
  for (const float z : {1.0f, 3.0f, 5.0f, 9.0f}) {
    const WarpedEye eye = warped(color, Image<float>(100, 10, z), view, pair);
    const double px = parallax_at(view, pair, double(z)).px;
    for (int x = 5; x < 95; ++x)
      CHECK(double(eye.color.at(x, 0).r) == Approx(2 * (x - px)).margin(1));
  }
}

TEST_CASE("with no separation there is one picture, and what cannot be warped is said") {
  const Stage stage = stage_of("cube", 32, 24, {0, 3});
  Renderer renderer(stage.scene, Transfer::kSrgb);
  SecondEye second;
  WarpedPair pair;
  render_pair_by_warp(renderer, stage.view, stage.pair, {}, {}, second, pair);
  CHECK(pair.rendering.left.color == pair.rendering.right.color);

  RenderSettings settings;
  CHECK(check_second_eye(stage.scene, settings, 2));
  settings.samples = 4;
  CHECK(check_second_eye(stage.scene, settings, 1));
  CHECK_FALSE(check_second_eye(stage.scene, settings, 2));
  settings.samples = 1;
  settings.show = Show::kNormal;
  CHECK_FALSE(check_second_eye(stage.scene, settings, 1));
  settings.show = Show::kColor;
  // A translucent material that no mesh uses does not matter.
  Scene glass = stage.scene;
  glass.materials.emplace_back().alpha_mode = AlphaMode::kBlend;
  CHECK(check_second_eye(glass, settings, 2));
  glass.materials[0].alpha_mode = AlphaMode::kBlend;
  CHECK(check_second_eye(glass, settings, 1));
  CHECK_FALSE(check_second_eye(glass, settings, 2));
}
