// Tests glassbox render --turntable: once around a scene. Tests --camera none: the automatic camera
// instead of the file's.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tests/app/text.h"

#include <glassbox/images/png_text.h>
#include <glassbox/images/read.h>
#include <glassbox/images/recipe.h>

namespace glassbox::test {
namespace {

using Direction3 = std::array<double, 3>;

// ---- what was drawn ----

Image<Rgba8> turntable_picture(const WorkingDirectory& here, const std::string& name) {
  const auto image = read_image(here.file(name));
  INFO(name);
  REQUIRE(image);
  return *image;
}

Recipe recipe(const WorkingDirectory& here, const std::string& name) {
  const std::string bytes = here.read(name);
  const auto text = read_png_text(std::as_bytes(std::span(bytes)));
  REQUIRE(text);
  const auto found = recipe_of(*text);
  REQUIRE(found);
  return *found;
}

Direction3 triple_after(const std::vector<std::string>& words, const std::string& option) {
  const auto at = std::find(words.begin(), words.end(), option);
  REQUIRE(at != words.end());
  Direction3 triple{};
  REQUIRE(std::sscanf(std::next(at)->c_str(), "%lf,%lf,%lf", &triple[0], &triple[1], &triple[2]) ==
          3);
  return triple;
}

double distance(const Direction3& a, const Direction3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

void render_turntable(const WorkingDirectory& here, const std::string& scene, std::size_t frames,
                      const std::string& options, const std::string& name = "t.png") {
  const Outcome outcome = here.run(
      fmt::format("render {} --frames {} --turntable {} -o {}", scene, frames, options, name));
  INFO(scene << " " << options << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
}

// Returns how far the drawn pixels extend from the middle, in halves of the width or height, the
// maximum over all sides; 1 is the border.
double farthest_extent(const Image<Rgba8>& image) {
  const Rgba8 background = image.at(0, 0);
  double most = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.at(x, y) == background) continue;
      const double across =
          std::max(std::abs(2.0 * x - image.width), std::abs(2.0 * (x + 1) - image.width)) /
          image.width;
      const double up =
          std::max(std::abs(2.0 * y - image.height), std::abs(2.0 * (y + 1) - image.height)) /
          image.height;
      most = std::max({most, across, up});
    }
  }
  return most;
}

// A long beam with a flag, far from the origin and without any symmetry.
const std::string kBeam =
    "v 95 0 0\nv 105 0 0\nv 105 0.5 0\nv 95 0.5 0\nv 105 3 2\nv 95 0 -1\n"
    "f 1 2 3 4\nf 2 5 3\nf 1 6 4\n";

TEST_CASE("a turntable's eye goes once around up through the target, at one distance and height") {
  for (const auto& [options, up] :
       std::vector<std::pair<std::string, Direction3>>{{"", {0, 1, 0}},
                                                       {"--up 0,0,1", {0, 0, 1}},
                                                       {"--up 0,2,0", {0, 1, 0}},
                                                       {"--up 1,0,0", {1, 0, 0}}}) {
    const WorkingDirectory here;
    constexpr std::size_t kFrames = 10;
    render_turntable(here, "teapot:2", kFrames, options + " --size 32x24");
    std::vector<Direction3> eyes;
    for (std::size_t i = 1; i <= kFrames; ++i) {
      const Recipe made = recipe(here, fmt::format("t-{:04}.png", i));
      eyes.push_back(triple_after(made.options, "--eye"));
      const Direction3 target = triple_after(made.options, "--look-at");
      CHECK(target == triple_after(recipe(here, "t-0001.png").options, "--look-at"));
      const auto along_up = [&up = up](const Direction3& p) {
        return p[0] * up[0] + p[1] * up[1] + p[2] * up[2];
      };
      INFO(options << " frame " << i);
      // The bound allows for a dozen roundings in double of numbers below 20.
      CHECK(std::abs(distance(eyes[i - 1], target) - distance(eyes[0], target)) < 1e-13);
      CHECK(std::abs(along_up(eyes[i - 1]) - along_up(eyes[0])) < 1e-13);
    }
    // The step from the last frame to the first is as long as the others: the loop is closed.
    const double step = distance(eyes[0], eyes[1]);
    for (std::size_t i = 0; i < kFrames; ++i) {
      CHECK(std::abs(distance(eyes[i], eyes[(i + 1) % kFrames]) - step) < 1e-13);
    }
    CHECK(step > 0);
  }
}

TEST_CASE("a frame of a turntable is the picture of its angle, whatever the number of frames") {
  const WorkingDirectory here;
  render_turntable(here, "f-glyph", 4, "--size 48x32", "a%d.ppm");
  render_turntable(here, "f-glyph", 8, "--size 48x32", "b%d.ppm");
  for (int i = 0; i < 4; ++i) {
    CHECK(here.read(fmt::format("a{}.ppm", i + 1)) == here.read(fmt::format("b{}.ppm", 2 * i + 1)));
  }
  CHECK(here.read("a1.ppm") != here.read("a2.ppm"));
}

TEST_CASE("all of a scene is in every frame of its turn, and the frame is not larger than needed") {
  const WorkingDirectory scene;
  scene.write("beam.obj", kBeam);
  for (const std::string& words : std::vector<std::string>{
           "teapot:3 --size 160x90", "f-glyph --size 90x160", "cube --size 96x96",
           "forest --size 96x64", scene.file("beam.obj") + " --size 160x90",
           scene.file("beam.obj") + " --size 64x200",
           scene.file("beam.obj") + " --size 160x90 --up 0,0,1",
           scene.file("beam.obj") + " --size 160x90 --fov 90",
           scene.file("beam.obj") + " --size 160x90 --look-at 100,2,0"}) {
    const WorkingDirectory here;
    const std::size_t blank = words.find(' ');
    render_turntable(here, words.substr(0, blank), 24, words.substr(blank));
    double most = 0;
    for (int i = 1; i <= 24; ++i) {
      const double one = farthest_extent(turntable_picture(here, fmt::format("t-{:04}.png", i)));
      INFO(words << " frame " << i);
      CHECK(one < 1);
      most = std::max(most, one);
    }
    // The margin is a tenth. The rest is lost because 24 angles do not meet the largest extent, and
    // to whole pixels.
    INFO(words);
    CHECK(most > 0.8);
  }
}

TEST_CASE("the recipe of a turntable's frame makes its pixels as a single picture") {
  for (const char* options :
       {"--size 40x30", "--size 40x30 --shade flat --fov 20 --up 0,1,1", "--size 40x30 --ortho 5",
        "--size 40x30 --eye 3,4,5 --look-at 0,1,0 --camera none",
        "--size 40x30 --stereo anaglyph"}) {
    const WorkingDirectory here;
    render_turntable(here, "teapot:2", 3, options);
    const Recipe made = recipe(here, "t-0002.png");
    std::string words = "render " + made.scene;
    for (const std::string& word : made.options) words += " " + word;
    INFO(words);
    REQUIRE(here.run(words + " -o alone.png").exit_code == 0);
    CHECK(turntable_picture(here, "alone.png") == turntable_picture(here, "t-0002.png"));
  }
}

TEST_CASE("--eye says where a turn begins") {
  const WorkingDirectory here;
  render_turntable(here, "cube", 4, "--size 16x16 --eye 0,3,5 --look-at 0,1,0");
  const auto eye = [&](int i) {
    return triple_after(recipe(here, fmt::format("t-{:04}.png", i)).options, "--eye");
  };
  CHECK(eye(1) == Direction3{0, 3, 5});
  CHECK(eye(2) == Direction3{5, 3, 0});  // to +x: counterclockwise as seen from above
  CHECK(eye(3) == Direction3{0, 3, -5});
  CHECK(eye(4) == Direction3{-5, 3, 0});
}

TEST_CASE("what has no extent can be turned as well") {
  const WorkingDirectory here;
  here.write("p.obj", "v 7 0 0\nv 7 0 0\nv 7 0 0\nf 1 2 3\n");
  render_turntable(here, "p.obj", 3, "--size 16x16");
}

TEST_CASE("a turn in stereo keeps the budget, with no path to name") {
  const WorkingDirectory here;
  const Outcome outcome =
      here.run("render forest --frames 6 --turntable --stereo anaglyph --size 96x64 -o t.png");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "(budget 3.00 %)"));
  CHECK(contains(here.read("t.svg"), "forest on a turntable"));
}

TEST_CASE("turntables that cannot be are refused") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"--turntable", {"--turntable", "--frames N"}},
      {"--frames 3", {"--path FILE.json, or --turntable"}},
      {"--frames 3 --turntable --path p.json", {"--turntable", "the path says"}},
      {"--frames 3 --turntable --camera 0", {"--camera", "--eye says where the camera starts"}},
      {"--frames 3 --turntable --up 0,0,0", {"up"}},
      {"--frames 3 --turntable --eye 0,5,0 --look-at 0,1,0", {"frame 1"}},
      {"--frames 3 --turntable --plot p.svg", {"--plot", "two eyes"}}};
  for (const auto& [options, parts] : cases) {
    const WorkingDirectory here;
    INFO(options);
    check_refused(here.run("render cube --size 16x16 " + options), parts);
    CHECK(here.names().empty());
  }
}

// ---- the file's camera ----

TEST_CASE("--camera none frames a scene as if its file had no camera") {
  const WorkingDirectory here;
  const std::string json =
      R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0CAMERA]}],
          "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0.3, 0.3, 4]}],
          "cameras": [{"name": "none", "type": "perspective",
                       "perspective": {"yfov": 0.4, "znear": 0.1}}],
          "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
          "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                         "min": [0, 0, 0], "max": [1, 1, 0]}],
          "bufferViews": [{"buffer": 0, "byteLength": 36}],
          "buffers": [{"byteLength": 36, "uri": "t.bin"}]})";
  const auto with = [&](const std::string& camera) {
    std::string text = json;
    return text.replace(text.find("CAMERA"), 6, camera);
  };
  here.write("camera.gltf", with(", 1"));
  here.write("plain.gltf", with(""));
  here.write("t.bin", float_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0}));
  const auto bytes = [&](const std::string& words) {
    const Outcome outcome = here.run("render " + words + " --size 32x24 -o - --format ppm");
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
  };
  CHECK(bytes("camera.gltf --camera none") == bytes("plain.gltf"));
  CHECK(bytes("camera.gltf --camera none --fov 20") == bytes("plain.gltf --fov 20"));
  CHECK(bytes("camera.gltf --camera none --eye 0,0,3") == bytes("plain.gltf --eye 0,0,3"));
  CHECK(bytes("camera.gltf") != bytes("plain.gltf"));
  CHECK(bytes("camera.gltf --camera 0") == bytes("camera.gltf"));  // a camera whose name is "none"
  CHECK(bytes("cube --camera none") == bytes("cube"));
  CHECK(contains(here.run("info camera.gltf --json -").out, "\"none\""));
}

}  // namespace
}  // namespace glassbox::test
