// Tests glassbox why: its answers about constructed scenes, and that the commands it suggests work.
#include "tests/support/catch.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/scenes.h"
#include "tests/app/sessions.h"
#include "tests/app/text.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Json why(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("why " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  return Json::parse(outcome.out);
}

// Returns the suggested commands: from each line with one, the words after the program's name.
std::vector<std::string> suggested(const std::string& text) {
  std::vector<std::string> commands;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    for (const char* subcommand : {" pixel ", " step ", " why "}) {
      const std::size_t at = line.find(subcommand);
      if (at != std::string::npos && contains(line.substr(0, at), "glassbox")) {
        commands.push_back(line.substr(at + 1));
      }
    }
  }
  return commands;
}

// A camera at (0, 0, 4) that looks down -z, for one front-facing triangle in the middle of the
// picture. (Materials of OBJ files are double-sided.)
constexpr const char* kLook =
    " --size 64x64 --eye 0,0,4 --look-at 0,0,0 --near 1 --far 10 --cull back";

void write_triangle(const WorkingDirectory& here, const std::string& name,
                    const std::string& vertices) {
  here.write(name, vertices + "f 1 2 3\n");
}

TEST_CASE("why names the stage and the number for each way in which a triangle is lost") {
  const WorkingDirectory here;
  write_triangle(here, "front.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\n");
  write_triangle(here, "back.obj", "v 1 -1 0\nv -1 -1 0\nv 0 1 0\n");
  write_triangle(here, "near.obj", "v -1 -1 3.5\nv 1 -1 3.5\nv 0 1 3.5\n");
  write_triangle(here, "far.obj", "v -1 -1 -9\nv 1 -1 -9\nv 0 1 -9\n");
  write_triangle(here, "behind.obj", "v -1 -1 5\nv 1 -1 6\nv 0 1 7\n");
  write_triangle(here, "line.obj", "v -1 -1 0\nv 0 0 0\nv 1 1 0\n");
  write_triangle(here, "tiny.obj", "v 0.01 0.01 0\nv 0.011 0.01 0\nv 0.01 0.011 0\n");
  write_triangle(here, "beside.obj", "v 8 -1 0\nv 9 -1 0\nv 8 1 0\n");
  const std::pair<const char*, const char*> cases[] = {
      {"front.obj", "visible"},        {"back.obj", "turned-away"},
      {"near.obj", "outside-plane"},   {"far.obj", "outside-plane"},
      {"behind.obj", "behind-eye"},    {"line.obj", "no-area"},
      {"tiny.obj", "between-centres"}, {"beside.obj", "outside-picture"}};
  for (const auto& [file, end] : cases) {
    const std::string words = std::string(file) + kLook;
    INFO(words);
    const Json json = why(here, words + " --triangle 0");
    CHECK(json["end"] == end);
    CHECK(json["triangle"] == 0);
    CHECK(!json["why"].empty());
    // The summary gives the same reason, with an example if nothing is visible.
    const Json all = why(here, words);
    CHECK(all["triangles"] == 1);
    REQUIRE(all["ends"].size() == 1);
    CHECK(all["ends"][0]["end"] == end);
    CHECK(all.contains("example") == (std::string(end) != "visible"));
  }
  const Json near = why(here, std::string("near.obj --triangle 0") + kLook);
  CHECK(near["clipping"]["plane"] == "near");
  for (const Json& corner : near["clipping"]["corners"]) CHECK(corner["along_gaze"] == 0.5);
  const Json behind = why(here, std::string("behind.obj --triangle 0") + kLook);
  CHECK(behind["clipping"]["corners"][0]["clip"][3] == -1);
  CHECK(behind["clipping"]["corners"][2]["clip"][3] == -3);
  CHECK(behind["view"]["hands_mixed"] == false);
}

TEST_CASE("why: what is seen is what the picture's numbers show") {
  const WorkingDirectory here;
  const std::string words = "teapot:3 --size 48x36";
  REQUIRE(here.run("render " + words + " -o p.png --id-out i.pfm").exit_code == 0);
  const Plane ids = parse_pfm(here.read("i.pfm"));
  std::map<int, int> pixels;
  for (const float id : ids.values) ++pixels[int(id)];
  int checked = 0;
  for (const auto& [id, count] : pixels) {
    if (id == 0 || id % 7 != 0) continue;
    const Json json = why(here, words + " --triangle " + std::to_string(id - 1));
    INFO(json.dump());
    CHECK(json["seen"] == true);
    CHECK(json["fragments"]["visible"] == count);
    const int x = json["fragments"]["example"][0], y = json["fragments"]["example"][1];
    CHECK(ids.at(x, y) == float(id));
    ++checked;
  }
  CHECK(checked > 10);
}

TEST_CASE("why: the commands that it suggests run") {
  const WorkingDirectory here;
  int run = 0;
  for (const char* words :
       {"cube --triangle 10 --size 64x64", "cube --triangle 0 --size 64x64 --shade flat",
        "teapot --triangle 0 --size 64x64", "room --size 64x48",
        "room --eye 0,1,9 --look-at 0,1,20 --size 64x48"}) {
    const Outcome outcome = here.run(std::string("why ") + words);
    INFO(words << "\n" << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 0);
    for (const std::string& command : suggested(outcome.out)) {
      INFO(command);
      CHECK(contains(command, "--size 64x"));
      CHECK(here.run(command).exit_code == 0);
      ++run;
    }
  }
  CHECK(run >= 7);
}

TEST_CASE("why: no line is wider than 100 columns") {
  const WorkingDirectory here;
  for (const char* words :
       {"cube --triangle 0 --size 64x64", "room --size 64x48", "teapot --triangle 1 --size 64x64",
        "room --eye 0,1,9 --look-at 0,1,20 --size 64x48"}) {
    const Outcome outcome = here.run(std::string("why ") + words);
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
      if (contains(line, "/glassbox "))
        continue;  // a command stays on one line, and the program's path is long here
      CHECK(line.size() <= 100);
    }
  }
}

TEST_CASE("why: JSON goes to a file beside what people read, or alone to standard output") {
  const WorkingDirectory here;
  const Outcome both = here.run("why cube --size 40x30 --triangle 3 --json w.json");
  CHECK(both.exit_code == 0);
  CHECK(both.out.find("triangle 3 of cube, 40 x 30: ") == 0);
  CHECK(here.run("why cube --size 40x30 --triangle 3 --json -").out == here.read("w.json"));
}

TEST_CASE("why: numbers that do not exist, no numbers and no scene are refused") {
  const WorkingDirectory here;
  here.write("empty.obj", "v 0 0 0\n");
  const std::pair<const char*, const char*> cases[] = {
      {"cube --triangle 12", "12 triangles, 0 .. 11"},
      {"cube --triangle 99999999999999", "12 triangles"},
      {"cube --triangle 99999999999999999999999", "--triangle"},
      {"cube --triangle -1", "--triangle"},
      {"cube --triangle 1.5", "--triangle"},
      {"cube --triangle x", "--triangle"},
      {"nothing.glb", "nothing.glb"},
      {"", "SCENE"},
      {"cube --near 3 --far 2", "far plane"},
      {"cube --json nowhere/w.json", "nowhere"}};
  for (const auto& [words, part] : cases) {
    const Outcome outcome = here.run(std::string("why ") + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(contains(outcome.err, part));
  }
}

TEST_CASE("a scene of lines has no triangle to ask about, and says so") {
  const WorkingDirectory here;
  here.write("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  const Outcome outcome = here.run("why line.obj --size 32x32");
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "0 triangles\n"));
  CHECK(contains(outcome.out, "glassbox pixel shows lines"));
  CHECK(here.run("why line.obj --triangle 0").exit_code == 2);
}

TEST_CASE("explain, pixel and why pass on a scene's warnings, and look at outputs before the run") {
  const WorkingDirectory here;
  here.write("a.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const std::string command : {"explain a.obj", "pixel a.obj --at 3,3", "why a.obj"}) {
    CAPTURE(command);
    const Outcome warned = here.run(command + " --size 16x16 --json -");
    CHECK(warned.exit_code == 0);
    CHECK(contains(warned.err, "glassbox: warning: "));
    CHECK(contains(warned.err, "none.mtl"));
    const Json json = Json::parse(warned.out);
    CHECK(json["scene"] == "a.obj");
    CHECK(json["width"] == 16);
    CHECK(json["height"] == 16);
    const Outcome refused = here.run(command + " --size 16x16 --json nowhere/a.json");
    CHECK(refused.exit_code == 2);
    CHECK(contains(refused.err, "nowhere/a.json: its directory does not exist"));
    CHECK(!contains(refused.err, "warning"));  // the scene was not loaded
  }
}

TEST_CASE("the sessions in docs/why.md are what the program prints") {
  CHECK(replay(WorkingDirectory(), "docs/why.md") > 8);
}

}  // namespace
}  // namespace glassbox::test
