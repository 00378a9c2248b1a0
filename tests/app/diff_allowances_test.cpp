// Tests the options of glassbox diff that other tools have, too: thresholds, shares of pixels,
// moved edges, opaque alpha and pictures of different sizes.
#include "tests/support/catch.h"

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/picture_file_kinds.h"

#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/images/read.h>

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

// The line that starts with a label, without the label.
std::string line_of(const std::string& out, const std::string& label) {
  const auto start = out.find(label);
  if (start == std::string::npos) return {};
  return out.substr(start + label.size(), out.find('\n', start) - start - label.size());
}

// Two renderings of a scene whose edges lie a third of a pixel apart. The colours of its faces do
// not depend on the eye.
class MovedScene {
public:
  MovedScene() {
    const std::string scene = "render cube --size 320x180 --samples 16 --shade unlit ";
    REQUIRE(here.run(scene + "--eye 3,2,4 -o a.png").exit_code == 0);
    REQUIRE(here.run(scene + "--eye 3.01,2,4 -o b.png").exit_code == 0);
  }
  WorkingDirectory here;
};

TEST_CASE("edges that moved are counted apart in text, JSON, heat map and page") {
  const MovedScene scene;
  const Outcome plain = scene.here.run("diff a.png b.png");
  CHECK(plain.exit_code == 1);
  CHECK(!contains(plain.out, "moved edges"));
  const Outcome outcome = scene.here.run(
      "diff a.png b.png --ignore-antialiasing --json r.json -o heat.png --html page.html");
  INFO(outcome.out);
  CHECK(contains(outcome.out, "at moved edges (by up to "));
  CHECK(contains(outcome.out, "tolerance: moved edges are ignored"));
  const Json found = Json::parse(scene.here.read("r.json"))["pictures"][0]["differences"];
  const auto moved = found["moved_edges"]["pixels"].get<int>();
  CHECK(moved > 300);
  CHECK(found["differing_pixels"].get<int>() * 20 < moved);
  const auto heat = value_of(read_image(scene.here.file("heat.png")));
  CHECK(std::count(heat.pixels.begin(), heat.pixels.end(), heat_colours()[kHeatMovedEdge]) ==
        moved);
  CHECK(contains(scene.here.read("page.html"), "\"moved_edges\""));
}

TEST_CASE("thresholds and numbers of pixels decide, and what they cannot be is refused") {
  const WorkingDirectory here;
  StoredImage image = sample_picture({"", "", 3, Format::kBytes, {}});
  for (int x = 0; x < 4; ++x) {
    for (int c = 0; c < 3; ++c) set_sample(image, x, 2, c, 100);
  }
  here.write("a.png", png_of(image));
  for (int x = 0; x < 4; ++x) {
    for (int c = 0; c < 3; ++c) set_sample(image, x, 2, c, 110 + 30 * (x / 3));
  }
  here.write("b.png", png_of(image));  // three pixels are 10 steps of grey lighter, one is 40
  const auto diff = [&](const std::string& options) {
    return here.run("diff a.png b.png " + options);
  };
  CHECK(diff("--threshold 0.04").exit_code == 1);
  CHECK(contains(diff("--threshold 0.04").out,
                 "a pixel is further apart than the threshold 0.04\n  and: 1 of 432 pixels differ, "
                 "by up to 40/255, in 1 region; first (3, 2): (100, 100, 100) became (140, 140, "
                 "140); set aside: 3 pixels below the threshold (by up to 10/255)"));
  CHECK(diff("--threshold 0.16").exit_code == 0);
  CHECK(diff("--threshold 0.04 --max-differing 1").exit_code == 0);
  CHECK(diff("--threshold 0.04 --max-differing 0.2%").exit_code == 1);
  CHECK(diff("--max-differing 4").exit_code == 0);
  CHECK(diff("--max-differing 1%").exit_code == 0);
  CHECK(contains(diff("--max-differing 3").out, "more than 3 of 432 pixels differ"));
  // All tolerances must hold together.
  CHECK(diff("--threshold 0.16 --metric absmax<0.1").exit_code == 1);
  check_refused(diff("--threshold 1.5"), {"--threshold", "1.5", "0.1"});
  check_refused(diff("--max-differing many"), {"--max-differing", "many", "0.1%"});
  check_refused(diff("--alpha maybe"), {"--alpha", "lenient|strict"});
  check_refused(diff("--align left"), {"--align", "top-left|centre|best"});
}

TEST_CASE("the suggested short options make the pictures pass") {
  const MovedScene scene;
  const Outcome outcome = scene.here.run("diff a.png b.png --suggest-fuzzy");
  const std::string fuzzy = line_of(outcome.out, "  fuzzy: "),
                    options = line_of(outcome.out, "  short: ");
  INFO(outcome.out);
  CHECK(fuzzy.find("maxDifference=0-") == 0);
  const auto comma = options.find(", or ");
  REQUIRE(comma != std::string::npos);
  for (const std::string& one :
       {"--fuzzy " + fuzzy, options.substr(0, comma), options.substr(comma + 5)}) {
    INFO(one);
    CHECK(scene.here.run("diff a.png b.png " + one).exit_code == 0);
    CHECK(scene.here.run("diff a.png a.png " + one).exit_code == 0);
  }
}

TEST_CASE("pictures of different sizes are compared, shown, and different unless asked otherwise") {
  const WorkingDirectory here;
  REQUIRE(here.run("render cube --size 60x40 -o large.png").exit_code == 0);
  const StoredImage large = value_of(read_stored(here.file("large.png")));
  StoredImage small = blank(50, 30, 3, Format::kBytes);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 50; ++x) {
      for (int c = 0; c < 3; ++c) set_sample(small, x, y, c, sample_at(large, x + 6, y + 7, c));
    }
  }
  here.write("small.png", png_of(small));
  const Outcome corner = here.run("diff large.png small.png");
  CHECK(corner.exit_code == 1);
  CHECK(contains(corner.out,
                 "different: the reference has 60 x 40 pixels, the test 50 x 30\n"
                 "  and: in the 50 x 30 pixels that both have, "));
  const Outcome best =
      here.run("diff large.png small.png --align best -o heat.png --html page.html --json r.json");
  CHECK(best.exit_code == 1);
  CHECK(contains(best.out, "the 50 x 30 pixels that both have are the same"));
  CHECK(contains(best.out, "the test begins at (6, 7)"));
  const auto heat = value_of(read_image(here.file("heat.png")));
  CHECK(heat.width == 60);
  CHECK(heat.height == 40);
  CHECK(std::count(heat.pixels.begin(), heat.pixels.end(), heat_colours()[kHeatNotCompared]) ==
        60 * 40 - 50 * 30);
  const Json canvas = Json::parse(here.read("r.json"))["pictures"][0]["canvas"];
  CHECK(canvas["test"] == Json({{"x", 6}, {"y", 7}, {"width", 50}, {"height", 30}}));
  CHECK(here.run("diff large.png small.png --align best --ignore-size").exit_code == 0);
  CHECK(here.run("diff large.png small.png --ignore-size").exit_code == 1);
}

TEST_CASE("in directories, opaque alpha channels are said once") {
  const WorkingDirectory here;
  for (const char* folder : {"old", "new"}) std::filesystem::create_directory(here.file(folder));
  StoredImage rgb = sample_picture({"", "", 3, Format::kBytes, {}});
  StoredImage rgba = blank(rgb.width, rgb.height, 4, Format::kBytes);
  for (int y = 0; y < rgb.height; ++y) {
    for (int x = 0; x < rgb.width; ++x) {
      set_sample(rgba, x, y, 3, 255);
      for (int c = 0; c < 3; ++c) set_sample(rgba, x, y, c, sample_at(rgb, x, y, c));
    }
  }
  for (const char* name : {"a.png", "b.png", "c.png"}) {
    here.write(std::string("old/") + name, png_of(rgb));
    here.write(std::string("new/") + name, png_of(rgba));
  }
  const Outcome outcome = here.run("diff old new");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("note: in 3 pairs, one picture has an alpha channel that is opaque") == 0);
  CHECK(contains(outcome.out, "3 pictures: 3 same"));
  CHECK(here.run("diff old new --alpha strict").exit_code == 1);
}

}  // namespace
}  // namespace glassbox::test
