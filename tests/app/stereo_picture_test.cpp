// Tests glassbox render --stereo and --seen-by: both eyes in one picture, from the command line.
#include <cmath>
#include <string>
#include <vector>

#include <glassbox/images/read.h>
#include <nlohmann/json.hpp>

#include "tests/app/working_directory.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

const std::string kEyes = " --eye-separation 0.2 --window 4 --size 64x37";

Image<Rgba8> stereo_picture(const WorkingDirectory& here, const std::string& words) {
  INFO(words);
  const Outcome outcome = here.run("render room " + words + " -o p.png");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto image = read_image(here.file("p.png"));
  REQUIRE(image);
  return *image;
}

}  // namespace

TEST_CASE("the layouts hold each eye's own picture (S0-02)") {
  const WorkingDirectory here;
  const Image<Rgba8> left = stereo_picture(here, "--seen-by left" + kEyes);
  const Image<Rgba8> right = stereo_picture(here, "--seen-by right" + kEyes);
  const int w = left.width, h = left.height;
  REQUIRE(w == 64);
  REQUIRE(h == 37);
  CHECK(!(left == right));

  const Image<Rgba8> anaglyph = stereo_picture(here, "--stereo anaglyph" + kEyes);
  const Image<Rgba8> green =
      stereo_picture(here, "--stereo anaglyph --glasses green-magenta" + kEyes);
  const Image<Rgba8> pair = stereo_picture(here, "--stereo pair" + kEyes);
  const Image<Rgba8> crossed = stereo_picture(here, "--stereo cross-eyed" + kEyes);
  const Image<Rgba8> over = stereo_picture(here, "--stereo over-under" + kEyes);
  const Image<Rgba8> rows = stereo_picture(here, "--stereo interlaced" + kEyes);
  REQUIRE(pair.width == 2 * w);
  REQUIRE(crossed.width == 2 * w);
  REQUIRE(over.height == 2 * h);
  REQUIRE(rows.height == h);
  int wrong = 0;
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const Rgba8 l = left.at(x, y), r = right.at(x, y);
      wrong += !(anaglyph.at(x, y) == Rgba8{l.r, r.g, r.b, 255});
      wrong += !(green.at(x, y) == Rgba8{r.r, l.g, r.b, 255});
      wrong += !(pair.at(x, y) == l) + !(pair.at(x + w, y) == r);
      wrong += !(crossed.at(x, y) == r) + !(crossed.at(x + w, y) == l);
      wrong += !(over.at(x, y) == l) + !(over.at(x, y + h) == r);
      wrong += !(rows.at(x, y) == (y % 2 == 0 ? l : r));
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("aligning and cropping makes the skewed pair where whole pixels are cut (S0-08)") {
  const WorkingDirectory here;
  // Infinity is shifted by s a W/f px, with a = 1 for a right angle: 0.25 * 64/4 = 4 px. The
  // picture is unlit, because each eye sees highlights in other places than the camera between
  // them.
  const std::string start =
      "--fov 90 --size 64x64 --window 4 --shade unlit --stereo pair --eye-separation ";
  const auto differing = [&](const std::string& separation) {
    const Image<Rgba8> skewed = stereo_picture(here, start + separation);
    const Image<Rgba8> cropped = stereo_picture(here, start + separation + " --eyes-by crop");
    REQUIRE(cropped.width == 128);
    REQUIRE(cropped.pixels.size() == skewed.pixels.size());
    int count = 0;
    for (std::size_t i = 0; i < skewed.pixels.size(); ++i)
      count += !(skewed.pixels[i] == cropped.pixels[i]);
    return count;
  };
  const int whole = differing("0.5"), halves = differing("0.5625");
  INFO(whole << " pixels differ at 4 px, " << halves << " at 4.5 px");
  CHECK(whole <= 64 * 64 * 2 / 1000);
  CHECK(halves > 10 * whole);
  const Outcome told = here.run(
      "render room --fov 90 --size 64x64 --window 4 --eye-separation 0.5 "
      "--stereo anaglyph --eyes-by crop --json q.json -o p.png");
  REQUIRE(told.exit_code == 0);
  CHECK(told.out.find("cropped from pictures 4 columns wider") != std::string::npos);
  const Json json = Json::parse(here.read("q.json"));
  CHECK(json.at("stereo").at("cropped").at("columns") == 4);
  for (const char* refused :
       {"--ortho 4 --stereo pair --eyes-by crop",
        "--stereo pair --eyes-by crop --stereo-cull centre", "--eyes-by crop"}) {
    const Outcome outcome = here.run(std::string("render cube --size 32x32 ") + refused);
    INFO(refused << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
  }
}

TEST_CASE("frames of cropped eyes are measured like those of skewed ones") {
  const WorkingDirectory here;
  const auto parallax = [&](const std::string& eyes) {
    const Outcome outcome = here.run(
        "render forest --size 96x64 --frames 2 --turntable --stereo anaglyph --json - --eyes-by " +
        eyes);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return Json::parse(outcome.out).at("frames").at(0);
  };
  const Json skewed = parallax("skew"), cropped = parallax("crop");
  CHECK(cropped.at("separation") == skewed.at("separation"));
  for (const char* name : {"in_front_px", "behind_px"}) {
    INFO(name);
    const double px = cropped.at(name);
    CHECK(px > 0);
    // Each eye's picture is shifted by at most half a pixel against that of the skewed frustum.
    CHECK(std::abs(px - skewed.at(name).get<double>()) <= 1);
  }
}

TEST_CASE("separation 0 gives the mono bytes in one pass (C-71)") {
  const WorkingDirectory here;
  const Image<Rgba8> mono = stereo_picture(here, "--size 64x37");
  CHECK(stereo_picture(here, "--stereo anaglyph --eye-separation 0 --size 64x37") == mono);
  const Json json = Json::parse(
      here.run("render room --stereo pair --eye-separation 0 --size 64x37 -o p.png --json -").out);
  CHECK(json.at("stereo").at("passes") == 1);
  CHECK(json.at("width") == 128);
}

TEST_CASE("the parallax that is printed is that of the formula, in pixels and per cent (S0-11)") {
  const WorkingDirectory here;
  const Json json =
      Json::parse(here.run("render teapot --size 64x64 --fov 90 --eye 0,0,8 --look-at 0,0,0 "
                           "--near 2 --far 16 --eye-separation 0.5 --window 4 --stereo pair "
                           "-o p.png --json -")
                      .out);
  // The formula is 2 s (W/2) (1/f - 1/z), with d/h = 1 for 90 degrees and a square picture.
  const Json& parallax = json.at("stereo").at("parallax");
  CHECK(parallax.at("near").at("px").get<double>() == 0.5 * 32 * (0.25 - 0.5));
  CHECK(parallax.at("window").at("px") == 0);
  CHECK(parallax.at("far").at("px").get<double>() == 0.5 * 32 * (0.25 - 0.0625));
  CHECK(parallax.at("far").at("percent_of_width").get<double>() == 0.5 * 32 * 0.1875 / 64 * 100);
}

TEST_CASE("colours are moved before the anaglyph, and a cable comes after it (S0-15, S0-17)") {
  const WorkingDirectory here;
  const std::string anaglyph = "--stereo anaglyph" + kEyes;
  const Image<Rgba8> plain = stereo_picture(here, anaglyph);
  CHECK(stereo_picture(here, anaglyph + " --desaturate 0 --brighten 0") == plain);
  CHECK(!(stereo_picture(here, anaglyph + " --cable composite") == plain));
  const Image<Rgba8> white = stereo_picture(here, anaglyph + " --brighten 1");
  CHECK(white == Image<Rgba8>(white.width, white.height, {255, 255, 255, 255}));
  // Without saturation and with both eyes in one place, the pair's pictures are grey.
  const Image<Rgba8> grey =
      stereo_picture(here, "--stereo pair --eye-separation 0 --size 64x37 --desaturate 1");
  int coloured = 0;
  for (const Rgba8& p : grey.pixels) coloured += p.r != p.g || p.g != p.b;
  CHECK(coloured == 0);
}

TEST_CASE("what makes no sense for two eyes is refused, with a remedy") {
  const WorkingDirectory here;
  struct Refusal {
    std::string words;
    std::vector<std::string> says;
  };
  for (const Refusal& refusal : std::vector<Refusal>{
           {"--stereo pair --eye-separation -0.1", {"exchanges the eyes"}},
           {"--stereo pair --eye-separation nan", {"finite"}},
           {"--stereo pair --eye-separation 1e9", {"width"}},
           {"--stereo pair --eye-separation much", {"--eye-separation", "much"}},
           {"--stereo pair --window 0.001", {"near plane"}},
           {"--stereo pair --window -3", {"in front of the camera"}},
           {"--stereo pair --far 20 --window 30", {"far plane"}},
           {"--stereo pair --window inf", {"--eye-separation"}},
           {"--stereo pair --ortho 4 --window inf --eye-separation 1", {"parallel"}},
           {"--stereo stack", {"--stereo", "interlaced"}},
           {"--stereo interlaced --size 64x1", {"two rows"}},
           {"--stereo pair --anaglyph dubois", {"--anaglyph", "not an anaglyph"}},
           {"--stereo pair --cable composite", {"--cable", "not an anaglyph"}},
           {"--stereo anaglyph --anaglyph dubois2001 --glasses amber-blue", {"red-cyan"}},
           {"--stereo anaglyph --desaturate 1.5", {"0", "1"}},
           {"--stereo anaglyph --seen-by left", {"--seen-by", "--stereo"}},
           {"--stereo pair --depth-out d.pfm", {"--depth-out", "--seen-by"}},
           {"--glasses red-cyan", {"--glasses", "--stereo"}},
           {"--window 3", {"--window", "--seen-by"}},
           {"--seen-by both", {"--seen-by", "left|right"}},
       }) {
    INFO(refusal.words);
    const Outcome outcome = here.run("render room " + refusal.words + " -o p.png");
    CHECK(outcome.exit_code == 2);
    for (const std::string& text : refusal.says) {
      INFO(outcome.err);
      CHECK(outcome.err.find(text) != std::string::npos);
    }
    CHECK(here.names().empty());
  }
}

TEST_CASE("a parallel projection has a pair, and says what it is") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("render teapot --ortho 5 --stereo pair --size 64x37 -o p.png");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("parallel projection") != std::string::npos);
}

}  // namespace glassbox::test
