// glassbox views match: of a scene whose disparities are known, of the pictures that render draws, and of what it cannot be asked.
#include "tests/support/catch.h"

#include <algorithm>
#include <fstream>
#include <string>

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

}  // namespace

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
  for (const char* words :
       {"a.png", "a.png none.png", "a.png other.png", "one.pgm one.pgm", "a.png a.png --range 5,2",
        "a.png a.png --range 40,90", "a.png a.png --range 0,1000000000",
        "a.png a.png --cost-window 4", "a.png a.png --paths 3", "a.png a.png --max-mb 0",
        "a.png a.png --truth other.png", "a.png a.png --calibration 100,0,0 --depth-out d.pfm",
        "a.png a.png --depth-out d.pfm", "a.png a.png --scene cube", "--scene nothing.glb",
        "a.png a.png --method best"}) {
    const Outcome outcome = here.run(std::string("views match ") + words + " -o out.pfm");
    INFO(words << ": " << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK_FALSE(std::ifstream(here.file("out.pfm")).good());
    CHECK_FALSE(std::ifstream(here.file("d.pfm")).good());
  }
}

}  // namespace glassbox::test
