// glassbox views match: of a scene whose disparities are known, of the pictures that render draws, and of what it cannot be asked.
#include "tests/support/catch.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <glassbox/images/read.h>
#include <glassbox/images/write.h>
#include <nlohmann/json.hpp>

#include "tests/app/run.h"

namespace glassbox::test {
namespace {

const std::string kPair = "--scene room --size 320x240 --eye-separation 0.2 ";

void write_pgm(const Workplace& here, const std::string& name, int width, int height) {
  const std::string size = std::to_string(width) + " " + std::to_string(height);
  here.write(
      name, "P5\n" + size + "\n255\n" + std::string(std::size_t(width) * std::size_t(height), '7'));
}

// Two pixels by two, of which one is half transparent.
std::string clear_png() {
  Image<Rgba8> image(2, 2, {10, 20, 30, 255});
  image.at(1, 1).a = 128;
  const auto bytes = encode_png(image);
  return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

// How many pixels of two pictures of one size differ by more than `codes` in some channel, per cent.
double differing(const std::string& a, const std::string& b, int codes) {
  const auto first = read_image(a), second = read_image(b);
  REQUIRE(first);
  REQUIRE(second);
  REQUIRE(first->pixels.size() == second->pixels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < first->pixels.size(); ++i) {
    const Rgba8 &p = first->pixels[i], &q = second->pixels[i];
    count += std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}) > codes;
  }
  return 100 * double(count) / double(first->pixels.size());
}

}  // namespace

TEST_CASE("the surface that views match writes is drawn again by render, as the left eye saw it") {
  const Workplace here;
  const Outcome outcome = here.run("views match " + kPair + "--ply room.ply");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  // The command's own last line.
  const std::size_t at = outcome.out.find(" render room.ply");
  REQUIRE(at != std::string::npos);
  const std::string words = outcome.out.substr(at, outcome.out.find('\n', at) - at);
  const Outcome drawn = here.run(words + " --cull none");
  INFO(words << "\n" << drawn.err);
  REQUIRE(drawn.exit_code == 0);
  REQUIRE(here.run("render room --size 320x240 --eye-separation 0.2 --seen-by left -o left.png")
              .exit_code == 0);
  // A vertex lies at its pixel's centre, where its colour is what is drawn, but for codes of rounding. Elsewhere are the gaps at jumps,
  // whose pixels are those of a triangle that is left out: an outline's, some pixels in a hundred.
  CHECK(differing(here.file("again.png"), here.file("left.png"), 2) < 10);
}

TEST_CASE(
    "pictures that are not rectified are turned by their cameras, and what was lost is said") {
  const Workplace here;
  REQUIRE(here.run("views geometry --scene room --size 320x240 --move 0.3,0.02,0.03 --turn -6,1,2 "
                   "--noise 0.2 --cameras-out c.txt --pair-out a.png b.png "
                   "--rectified-out ra.png rb.png --json g.json")
              .exit_code == 0);
  const auto geometry = nlohmann::json::parse(here.read("g.json"));
  CHECK(geometry["rectification"]["lost_percent"]["left"] > 0);
  CHECK(geometry["rectification"]["H_left"].size() == 3);
  const Outcome outcome = here.run(
      "views match a.png b.png --cameras c.txt --range -10,60 --rectified-out l.png r.png "
      "--depth-out d.pfm --json -");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  // One unit of the world's, which --cameras-out has: the baseline is |(0.3, 0.02, 0.03)|.
  CHECK(json["rectification"]["baseline"].get<double>() == Approx(0.30216).margin(1e-4));
  const Plane depth = parse_pfm(here.read("d.pfm"));
  REQUIRE(here.run("render room --size 320x240 --depth-out true.pfm -o t.png").exit_code == 0);
  // The middle of the picture shows the room's far wall; it is turned by some degrees, and its depth by some per cent.
  std::vector<float> middle;
  for (int y = 110; y < 130; ++y) {
    for (int x = 150; x < 170; ++x) middle.push_back(depth.at(x, y));
  }
  std::ranges::nth_element(middle, middle.begin() + 200);
  CHECK(middle[200] > 1);
  CHECK(middle[200] < 20);
  CHECK(read_image(here.file("l.png"))->width == 320);
  for (const char* words :
       {"a.png b.png --cameras c.txt --truth d.pfm",
        "a.png b.png --cameras c.txt --calibration 1,1,0", "--scene room --cameras c.txt"}) {
    INFO(words);
    CHECK(here.run(std::string("views match ") + words).exit_code == 2);
  }
  // The pictures as they are do not lie in rows.
  CHECK(here.run("views geometry --matches none.csv --rectified-out l.png r.png").exit_code == 2);
}

TEST_CASE("views match writes a page of its pair, with and without a truth") {
  const Workplace here;
  REQUIRE(here.run("views match --scene room --size 64x48 --eye-separation 0.2 --html a.html")
              .exit_code == 0);
  const std::string page = here.read("a.html");
  for (const char* id : {"disparity", "truth", "marks", "confidence", "sums", "manifest"}) {
    CHECK(page.find("id=\"" + std::string(id) + "\"") != std::string::npos);
  }
  REQUIRE(here.run("render cube --size 32x24 -o cube.png").exit_code == 0);
  REQUIRE(here.run("views match cube.png cube.png --range 0,9 --html b.html").exit_code == 0);
  CHECK(here.read("b.html").find("id=\"truth\"") == std::string::npos);
}

TEST_CASE("bench matches pairs beside OpenCV, or says that it is not there") {
  const Workplace here;
  const Outcome outcome =
      here.run("bench room --against opencv --size 64x48 --frames 1 --threads 1 --json -");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  const auto& matchers = json["pairs"][0]["matchers"];
  if (json["peer"] == "") {
    CHECK(json["notes"][0].get<std::string>().starts_with("OpenCV is left out: "));
    CHECK(matchers.size() == 2);
  } else {
    CHECK(matchers.size() == 4);
  }
  for (const auto& one : matchers) CHECK(one["bad_percent"]["1"] <= 100);
  CHECK(here.run("bench room --against opencv --scaling pixels").exit_code == 2);
  CHECK(here.run("bench nothing.glb --against opencv --frames 1").exit_code == 2);
}

TEST_CASE(
    "views match finds the disparities of a scene's pair, the same for every target and threads "
    "(S2-04)") {
  const Workplace here;
  const Outcome outcome = here.run("views match " + kPair + "-o disparity.pfm --json -");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["width"] == 320);
  // Of what both eyes see, and has a texture to be told by, one pixel in a hundred at most is more than a pixel off (docs/matching.md).
  const auto& textured = json["errors"]["visible_and_textured"];
  CHECK(textured["density_percent"] == 100);
  CHECK(textured["bad_percent"]["1"] < 1);
  const std::string disparity = here.read("disparity.pfm");
  for (const char* more : {"--target scalar", "--threads 1", "--threads 3"}) {
    REQUIRE(here.run("views match " + kPair + "-o again.pfm " + more).exit_code == 0);
    CHECK(here.read("again.pfm") == disparity);
  }
}

TEST_CASE("what views match cannot be asked is refused in a line, and no file is left") {
  const Workplace here;
  REQUIRE(here.run("render cube --size 32x24 -o a.png").exit_code == 0);
  REQUIRE(here.run("render cube --size 24x32 -o other.png").exit_code == 0);
  write_pgm(here, "one.pgm", 1, 1);
  here.write("clear.png", clear_png());
  for (const char* words : {"a.png",
                            "a.png none.png",
                            "a.png other.png",
                            "one.pgm one.pgm",
                            "a.png a.png --range 5,2",
                            "a.png a.png --range 40,90",
                            "a.png a.png --range 0,1000000000",
                            "a.png a.png --cost-window 4",
                            "a.png a.png --paths 3",
                            "a.png a.png --max-mb 0",
                            "a.png a.png --truth other.png",
                            "a.png a.png --calibration 100,0,0 --depth-out d.pfm",
                            "a.png a.png --depth-out d.pfm",
                            "a.png a.png --scene cube",
                            "--scene nothing.glb",
                            "a.png a.png --method best",
                            "a.png a.png --planes 9",
                            "a.png a.png --ply d.pfm",
                            "a.png a.png --calibration 100,0,0 --ply s.ply",
                            "a.png a.png --html page.txt",
                            "a.png a.png --rectified-out l.png r.png",
                            "a.png a.png --cameras none.txt",
                            "clear.png clear.png",
                            "a.png a.png --calibration 100,1,-1000 --ply s.ply"}) {
    const Outcome outcome = here.run(std::string("views match ") + words + " -o out.pfm");
    INFO(words << ": " << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK_FALSE(std::ifstream(here.file("out.pfm")).good());
    CHECK_FALSE(std::ifstream(here.file("d.pfm")).good());
    CHECK_FALSE(std::ifstream(here.file("s.ply")).good());
  }
}

}  // namespace glassbox::test
