// Tests glassbox views glyphs: it writes a wall, finds the glyphs and the camera in pictures of it,
// and refuses wrong requests.
#include "tests/support/catch.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/working_directory.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

}  // namespace

TEST_CASE("a wall is photographed, its glyphs are found, and the camera is that of the ring") {
  const WorkingDirectory here;
  const Outcome sheet = here.run("views glyphs sheet -o wall.glb --json wall.json");
  INFO(sheet.err);
  REQUIRE(sheet.exit_code == 0);
  CHECK(Json::parse(here.read("wall.json"))["glyphs"].size() == 120);
  REQUIRE(here.run("views ring wall.glb -o shots --views 2 --arc 20 --start -10 --elevation 4 "
                   "--distance 2 "
                   "--fov 40 --size 640x480 --background 0.5,0.5,0.5")
              .exit_code == 0);
  for (const char* lens : {"--fov 40", "", "--lens square"}) {
    const Outcome found = here.run(std::string("views glyphs find shots/view001.png --against "
                                               "shots/ring_par.txt --html found.html --json - ") +
                                   lens);
    INFO(lens << ": " << found.err);
    REQUIRE(found.exit_code == 0);
    const Json json = Json::parse(found.out);
    CHECK(json["score"]["wrong"] == 0);
    const int right = json["score"]["right"], visible = json["score"]["visible"];
    CHECK(visible >= 30);
    CHECK(30 * right >= 29 * visible);
    CHECK(json["error"]["degrees"] < 0.1);
    CHECK(json["error"]["millimetres"] < 2);
  }
  CHECK(here.read("found.html").find("id=\"manifest\"") != std::string::npos);
  // With the grid of another wall, no camera fits.
  const Outcome other = here.run("views glyphs find shots/view001.png --grid 5x12");
  CHECK(other.exit_code == 1);
  CHECK(other.out.find("no camera") != std::string::npos);
}

TEST_CASE("a panel is printed at its size, and read from the print") {
  const WorkingDirectory here;
  REQUIRE(
      here.run("views glyphs sheet -o sheet.png --pitch 28 --diameter 21 --dpi 100").exit_code ==
      0);
  // The sheet has a white margin, as on a table: glyphs at the picture's border would not be whole.
  const Outcome found =
      here.run("views glyphs find sheet.png --pitch 28 --diameter 21 --fov 40 --json -");
  REQUIRE(found.exit_code == 0);
  CHECK(Json::parse(found.out)["glyphs"] == 60);
}

TEST_CASE("walls, pictures and cameras that are none are refused in a line") {
  const WorkingDirectory here;
  REQUIRE(here.run("render cube --size 64x48 -o cube.png").exit_code == 0);
  here.write("bad_par.txt", "1\ncube.png 1 2 3\n");
  here.write("short.png", here.read("cube.png").substr(0, 60));
  here.write("text.png", "no picture");
  std::filesystem::create_directory(here.file("folder"));
  here.write("other_par.txt", "1\nother.png 9 0 5 0 9 5 0 0 1 1 0 0 0 1 0 0 0 1 0 0 0\n");
  for (const char* words : {"sheet -o wall.obj",
                            "sheet -o nowhere/wall.glb",
                            "sheet -o a.png --panel 3",
                            "sheet -o a.png --dpi 0",
                            "sheet -o a.png --dpi 1e9",
                            "sheet -o a.glb --grid 11x11",
                            "sheet -o a.glb --panels 0",
                            "sheet -o a.glb --first 2147483647",
                            "sheet -o a.glb --diameter 120",
                            "sheet -o a.glb --pitch nan",
                            "find nothing.png",
                            "find folder",
                            "find short.png",
                            "find text.png",
                            "find cube.png --against folder",
                            "find cube.png --html nowhere/a.html",
                            "find cube.png --html folder",
                            "find cube.png --json nowhere/a.json",
                            "find cube.png --fov nan",
                            "find cube.png --fov 0",
                            "find cube.png --threshold 0",
                            "find cube.png --against nothing.txt",
                            "find cube.png --against bad_par.txt",
                            "find cube.png --against other_par.txt",
                            "find cube.png --without nothing",
                            "find cube.png --html a.txt",
                            "sweep nothing",
                            "sweep",
                            "sweep rules --threshold -1"}) {
    const Outcome outcome = here.run(std::string("views glyphs ") + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
  }
  CHECK_FALSE(std::filesystem::exists(here.file("a.png")));
  CHECK_FALSE(std::filesystem::exists(here.file("a.glb")));
  // A picture without glyphs is not an error of usage, but gives no camera.
  CHECK(here.run("views glyphs find cube.png").exit_code == 1);
  const Outcome rules = here.run("views glyphs sweep rules --json -");
  REQUIRE(rules.exit_code == 0);
  CHECK(Json::parse(rules.out)["levels"].size() == 10);
}

}  // namespace glassbox::test
