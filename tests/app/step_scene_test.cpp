// Tests glassbox step SCENE: a triangle of a scene in every stage.
#include <nlohmann/json.hpp>

#include "tests/app/text.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) longest = std::max(longest, line.size());
  return longest;
}

TEST_CASE("step carries a triangle through every space, in order, within 100 columns") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("step room --size 320x180 --pick 160,90");
  REQUIRE(outcome.exit_code == 0);
  std::size_t at = 0;
  for (const char* stage :
       {"object space", "object -> world", "world -> eye", "eye -> clip", "clipping", "clip -> NDC",
        "NDC -> screen", "setup", "fragments", "the picture"}) {
    CAPTURE(stage);
    const std::size_t found = outcome.out.find(stage, at);
    REQUIRE(found != std::string::npos);
    at = found;
  }
  CHECK(contains(outcome.out, "the fragment of pixel (160, 90)"));
  CHECK(longest_line(outcome.out) <= 100);
  CHECK(longest_line(here.run("step room --size 320x180 --pick 160,90 --bits").out) <= 115);
}

TEST_CASE("a picked triangle is the one that the pixel shows, and its bytes are the pixel's") {
  const WorkingDirectory here;
  const std::string picture = " room --size 320x180 ";
  const Json pixel = Json::parse(here.run("pixel" + picture + "--at 160,90 --json -").out);
  const Json step = Json::parse(here.run("step" + picture + "--pick 160,90 --json -").out);
  REQUIRE(step.at("schema") == "glassbox-trace/1");
  REQUIRE(step.at("triangles").size() == 1);
  CHECK(step.at("triangles")[0].at("number") == pixel.at("triangle"));
  bool found = false;
  for (const Json& fragment : step.at("fragments")) {
    if (fragment.at("pixel") != Json({160, 90})) continue;
    found = true;
    CHECK(fragment.at("after") == pixel.at("color"));
    CHECK(fragment.at("fate") == "written");
  }
  CHECK(found);
}

TEST_CASE("one vertex alone, its bits, and what clipping made") {
  const WorkingDirectory here;
  const Outcome one = here.run("step cube --triangle 4 --vertex 1 --bits");
  REQUIRE(one.exit_code == 0);
  CHECK(contains(one.out, "vertex 1"));
  CHECK(!contains(one.out, "vertex 0"));
  CHECK(contains(one.out, "3f800000"));

  const Outcome cut = here.run("step cube --triangle 2 --eye 0,0,1.5 --look-at 0.2,0,0 --near 1.2");
  REQUIRE(cut.exit_code == 0);
  CHECK(contains(cut.out, "plane leaves"));
}

TEST_CASE("step refuses what it cannot step through, and says what to do") {
  const WorkingDirectory here;
  for (const auto& [words, part] : {std::pair{"step", "--triangle"},
                                    {"step cube", "--pick"},
                                    {"step cube --triangle 12", "12 triangles"},
                                    {"step cube --triangle -1", "--triangle"},
                                    {"step cube --triangle 1 --vertex 3", "--vertex"},
                                    {"step cube --pick 0,0", "no triangle is visible"},
                                    {"step cube --pick 1280,0", "1280 x 720"},
                                    {"step cube --pick 1.5,0", "whole pixels"},
                                    {"step cube --triangle 1 --pick 3,3", "excludes"},
                                    {"step cube --triangle 1 --point 0,0,0", "a scene as well"},
                                    {"step nothing.glb --triangle 1", "nothing.glb"}}) {
    CAPTURE(words);
    const Outcome outcome = here.run(words);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, part));
    CHECK(outcome.out.empty());
  }
}

TEST_CASE("JSON of a triangle that fills the picture is refused beyond --max-mb, unwritten") {
  const WorkingDirectory here;
  const std::string run = "step room --triangle 0 --size 320x180 --json big.json --max-mb ";
  const Outcome refused = here.run(run + "5");
  CHECK(refused.exit_code == 2);
  CHECK(contains(refused.err, "--max-mb 5: the triangle has 4"));
  CHECK(contains(refused.err, "fragments, about 1"));
  CHECK(contains(refused.err, "--max-mb 1"));
  CHECK(here.names().empty());
  CHECK(here.run(run + "-1").exit_code == 2);
  REQUIRE(here.run(run + "12").exit_code == 0);
  // The predicted size is within a tenth of the actual one.
  const double megabytes = double(here.read("big.json").size()) / 1e6;
  CAPTURE(megabytes);
  CHECK(megabytes > 9);
  CHECK(megabytes < 12);
}

TEST_CASE("by hand: next, back, jump, another camera and what it changes") {
  const WorkingDirectory here;
  const std::string step = std::string(GLASSBOX_PROGRAM) + " step cube --triangle 4 --interactive";
  const auto say = [&](const std::string& commands) {
    here.write("commands", commands);
    here.write("go.sh", "cd \"$(dirname \"$0\")\" && exec " + step + " < commands\n");
    const Outcome outcome = run_program("/bin/sh", {here.file("go.sh")}, here.path());
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
  };
  CHECK(contains(say("n\nq\n"), "object -> world"));
  CHECK(contains(say("clip\nback\nq\n"), "world -> eye"));
  CHECK(contains(say("back\nq\n"), "this is the first stage"));
  CHECK(contains(say("nowhere\nq\n"), "no stage or command"));
  CHECK(contains(say("--fov 400\n"), "between 0 and 180"));
  const std::string moved = say("--eye 2,2,3\nreset\nq\n");
  CHECK(contains(moved, "+      the eye stands at (2, 2, 3)"));
  CHECK(contains(moved, "-      the eye stands at (2, 2, 3)"));
  // Only the stages that change are shown.
  CHECK(!contains(moved.substr(moved.find("1/8>")), "as modelled"));
}

}  // namespace
}  // namespace glassbox::test
