// glassbox views layers: what it builds and draws of scenes whose truth is known, and what it refuses.
#include "tests/support/catch.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/run.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Json answer(const Workplace& here, const std::string& words) {
  const Outcome outcome = here.run("views layers " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

// A little to the right of the room's door.
const std::string kBeside = " --eye 1.75,1.62,-0.3 --look-at 0.68,1.39,-2.46 ";

}  // namespace

TEST_CASE("layers drawn from their own view are the picture that render draws, byte for byte") {
  const Workplace here;
  REQUIRE(here.run("render room --size 96x64 -o render.png").exit_code == 0);
  const Json built = answer(here, "build room --size 96x64 -o room.ldi");
  CHECK(built["covered_pixels"] == 96 * 64);
  CHECK(built["depth_complexity"] > 1.2);
  for (const char* more : {"--order depth", "--order occlusion", "--splat point --threads 3"}) {
    const Json drawn =
        answer(here, std::string("draw room.ldi -o same.png --against room ") + more);
    CHECK(drawn["against"]["wrong_pixels"] == 0);
    CHECK(drawn["pixels_without_sample"] == 0);
    CHECK(here.run("diff render.png same.png").exit_code == 0);
  }
}

TEST_CASE(
    "more layers leave fewer holes beside their view, and more of the picture right (S1-01)") {
  const Workplace here;
  std::size_t holes = 96 * 64, wrong = 96 * 64;
  for (const char* layers : {"1", "2", "10"}) {
    answer(here, std::string("build room --size 96x64 -o room.ldi --layers ") + layers);
    const Json drawn = answer(here, "draw room.ldi -o beside.png --against room" + kBeside);
    const auto now = drawn["against"]["holes"].get<std::size_t>();
    const auto wrong_now = drawn["against"]["wrong_pixels"].get<std::size_t>();
    CHECK(now < holes);
    CHECK(wrong_now < wrong);
    holes = now;
    wrong = wrong_now;
  }
  // What is left lies beside the first picture: a few columns of 96.
  CHECK(holes < 96 * 64 / 100);
  const Json one = answer(here, "draw room.ldi -o one.png" + kBeside);
  const Json many = answer(here, "draw room.ldi -o many.png --threads 4" + kBeside);
  CHECK(one["samples_drawn"] == many["samples_drawn"]);
  CHECK(here.run("diff one.png many.png").exit_code == 0);
}

TEST_CASE("what cannot be built or drawn is refused in a line, and no file is left") {
  const Workplace here;
  REQUIRE(here.run("views layers build cube --size 24x16 -o cube.ldi").exit_code == 0);
  std::ofstream(here.file("text.ldi")) << "glassbox-layers 1\nand no more";
  for (const char* words :
       {"build room -o room.png", "build room -o room.ldi --layers 0",
        "build room -o room.ldi --layers 256", "build room -o room.ldi --wireframe",
        "build room -o room.ldi --samples 4", "build room -o room.ldi --show depth",
        "build nothing.glb -o room.ldi", "draw none.ldi -o a.png", "draw text.ldi -o a.png",
        "draw cube.ldi -o a.gif", "draw cube.ldi -o a.png --size 0x3",
        "draw cube.ldi -o a.png --threads 0", "draw cube.ldi -o a.png --against nothing.glb",
        "draw cube.ldi -o a.png --splat round",
        "draw cube.ldi -o a.png --eye 0,0,0 --look-at 0,0,0"}) {
    const Outcome outcome = here.run(std::string("views layers ") + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK_FALSE(std::ifstream(here.file("a.png")).good());
    CHECK_FALSE(std::ifstream(here.file("room.ldi")).good());
  }
}

}  // namespace glassbox::test
