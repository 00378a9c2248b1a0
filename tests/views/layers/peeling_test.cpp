// The surfaces behind a picture: the same from both engines, and those of them that a second eye
// would see (S1-01, S1-09).
#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/stereo/parallax.h>

#include "tests/support/catch.h"
#include "views/layers/depth_peeling.h"
#include "views/layers/disocclusion.h"
#include "views/layers/second_eye.h"

using namespace glassbox;
using namespace glassbox::views;

namespace {

View view_of(const Scene& scene, int width, int height, DepthRange range = DepthRange::kStandard) {
  const Camera camera = scene.cameras.empty()
                            ? framing_camera(scene, double(width) / height).value()
                            : scene.cameras[0];
  return make_view(camera, width, height, range).value();
}

RenderSettings all_planes(DepthFormat format) {
  RenderSettings settings;
  settings.depth = format;
  settings.want_depth = settings.want_distance = settings.want_id = true;
  return settings;
}

bool are_same(const Framebuffer& a, const Framebuffer& b) {
  return a.color.pixels == b.color.pixels && a.depth.pixels == b.depth.pixels &&
         a.distance.pixels == b.distance.pixels && a.id.pixels == b.id.pixels;
}

}  // namespace

TEST_CASE(
    "what is behind a picture has the same bytes from both engines, whatever they draw it with") {
  for (const char* name : {"room", "forest", "thicket"}) {
    const Scene scene = make_builtin(name).value();
    for (const DepthFormat format :
         {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed, DepthFormat::kUnorm16}) {
      const bool reversed = format == DepthFormat::kFloat32Reversed;
      const View view =
          view_of(scene, 83, 61, reversed ? DepthRange::kReversed : DepthRange::kStandard);
      const RenderSettings settings = all_planes(format);
      Renderer staged(scene, settings.transfer, EngineKind::kStaged);
      Rendering shown = staged.render(view, settings);
      // In a third of the pixels nothing is drawn behind.
      Image<std::uint32_t> behind = shown.buffers.depth;
      for (int y = 0; y < 61; ++y) std::fill_n(&behind.at((7 * y) % 56, y), 27, kEmptyDepth);
      Rendering expected;
      staged.render(view, settings, expected, &behind);
      // Then a pixel has one sample, even if the settings request more.
      RenderSettings sampled = settings;
      sampled.samples = 4;
      for (const EngineKind kind : {EngineKind::kStaged, EngineKind::kTile}) {
        Rendering same;
        Renderer(scene, settings.transfer, kind).render(view, sampled, same, &behind);
        CHECK(are_same(same.buffers, expected.buffers));
      }
      int drawn = 0;
      for (std::size_t i = 0; i < behind.pixels.size(); ++i) {
        const std::uint32_t code = expected.buffers.depth.pixels[i];
        drawn += code != kEmptyDepth;
        REQUIRE(
            (code == kEmptyDepth || (behind.pixels[i] != kEmptyDepth && code > behind.pixels[i])));
      }
      INFO(name << ", format " << int(format) << ": " << drawn << " pixels");
      CHECK(drawn > 100);
      for (const Target target : available_targets()) {
        for (const int side : {16, 64}) {
          for (const int threads : {1, 3}) {
            TileOptions options;
            options.target = target;
            options.tile_side = side;
            options.threads = threads;
            Renderer tiled(scene, settings.transfer, EngineKind::kTile, options);
            Rendering found;
            tiled.render(view, settings, found, &behind);
            CHECK(are_same(found.buffers, expected.buffers));
          }
        }
      }
    }
  }
}

TEST_CASE("memory that has had one picture has the next one's bytes") {
  const Scene scene = make_builtin("room").value();
  const View view = view_of(scene, 64, 48);
  const RenderSettings settings = all_planes(DepthFormat::kFloat32);
  Renderer renderer(scene, settings.transfer);
  const Rendering first = renderer.render(view, settings);
  Rendering again;
  renderer.render(view, settings, again, &first.buffers.depth);
  CHECK_FALSE(are_same(again.buffers, first.buffers));
  renderer.render(view, settings, again);
  CHECK(are_same(again.buffers, first.buffers));
}

TEST_CASE("S1-01: each layer is behind the one before it, and the last one shows nothing more") {
  const Scene scene = make_builtin("forest").value();
  const View view = view_of(scene, 64, 48);
  const std::vector<Layer> layers = peel(scene, view, {}, 99);
  REQUIRE(layers.size() > 3);
  REQUIRE(layers.size() < 99);
  for (std::size_t i = 1; i < layers.size(); ++i) {
    CHECK_FALSE(is_empty(layers[i]));
    for (std::size_t p = 0; p < layers[i].depth.pixels.size(); ++p) {
      const std::uint32_t code = layers[i].depth.pixels[p];
      REQUIRE((code == kEmptyDepth || code > layers[i - 1].depth.pixels[p]));
    }
  }
}

// The depths of this row are standard depths with near plane 1 and an infinite far plane: the code
// of 1 - 1 / distance.
TEST_CASE("a line of sight goes on to the first place that the other eye would see") {
  // In px: a point at infinity does not move, a point at distance z moves by 20 / z to the left.
  const EyeShift shift{DepthFormat::kFloat32, 1, -1, 0, 20};
  const auto code = [](double z) { return depth_code(DepthFormat::kFloat32, float(1 - 1 / z)); };
  constexpr int kWidth = 40;
  // A card at distance 2 in front of a wall at 10: the card moves by 10, the wall by 2. The hole
  // reaches from the card's right edge, 30 - 10, to the wall's first pixel, 30 - 2.
  std::vector<std::uint32_t> last(kWidth, code(10)), behind(kWidth);
  std::fill(last.begin() + 20, last.begin() + 30, code(2));
  std::vector<Rgba8> colors(kWidth);
  std::vector<std::uint32_t> color(kWidth + 1), nearness(kWidth + 1, 0);
  std::vector<float> scratch(2 * kWidth + 256);
  const EyeTarget to{color.data(), nearness.data()};
  eye_kernels(Target::kScalar)
      .warp_row(shift, {colors.data(), last.data(), kWidth, true}, scratch.data(), to);
  for (int q = 0; q < kWidth; ++q) {
    INFO(q);
    CHECK((nearness[std::size_t(q)] == 0) == ((q >= 20 && q < 28) || q >= 38));
  }
  DisocclusionBuffers memory;
  REQUIRE(find_disocclusions(shift, last.data(), kWidth, to, memory, behind.data()));
  for (int x = 0; x < kWidth; ++x) {
    INFO(x << ": " << behind[std::size_t(x)]);
    const bool card = x >= 20 && x < 30;
    // The line of sight of the wall at x < 20 goes on to x + 1/2: it reaches the hole that begins
    // at 20 for x = 20 at the earliest, and the hole at the right edge, which begins at 38, for x =
    // 38.
    if (!card) {
      CHECK((behind[std::size_t(x)] != kEmptyDepth) == (x >= 38));
      continue;
    }
    // The line of sight of the card goes on to a pixel before the hole, at 19, at the earliest: x +
    // 1/2 - 20 / z = 19; and at least to a pixel beyond the card's own place.
    const double place = std::max(x + 0.5 - 10 + 1, 19.0), z = 20 / (x + 0.5 - place);
    CHECK(double(behind[std::size_t(x)]) == Approx(double(code(z))).margin(4));
  }
}

TEST_CASE("a surface that jumps over another one is looked for there") {
  // A fence of thin posts at distance 2 in front of a wall at 10, as the second eye sees it: behind
  // a post that is seen in front of the wall there may be another one.
  const EyeShift shift{DepthFormat::kFloat32, 1, -1, 0, 20};
  constexpr int kWidth = 8;
  std::vector<std::uint32_t> color(kWidth + 1), nearness(kWidth + 1, 0);
  const auto near = [](double z) { return std::bit_cast<std::uint32_t>(float(1 / z)) + 1; };
  for (int q = 0; q < kWidth; ++q) nearness[std::size_t(q)] = near(10);
  nearness[2] = near(2);  // comes from 2 + 10; the wall after it comes from q + 2
  std::vector<std::uint32_t> last(kWidth, depth_code(DepthFormat::kFloat32, 1 - 1 / 4.0f));
  std::vector<std::uint32_t> behind(kWidth);
  DisocclusionBuffers memory;
  const EyeTarget to{color.data(), nearness.data()};
  CHECK(find_disocclusions(shift, last.data(), kWidth, to, memory, behind.data()));
  // A line of sight that ends at x + 1/2 is in front of all that comes from further left: the wall
  // at q >= 3 comes from q + 2 1/2, which is more than a pixel less for x > q + 3.
  for (int x = 0; x < kWidth; ++x) {
    INFO(x);
    CHECK((behind[std::size_t(x)] != kEmptyDepth) == (x >= 7));
  }
  // Where nothing is open, there is nothing to find.
  nearness[2] = near(10);
  CHECK_FALSE(find_disocclusions(shift, last.data(), kWidth, to, memory, behind.data()));
  CHECK(std::ranges::all_of(behind, [](std::uint32_t code) { return code == kEmptyDepth; }));
}
