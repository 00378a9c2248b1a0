// Tests glassbox render --report: the picture's bytes stay the same, the report states how exact
// they are, and commands show the places it names.
#include "tests/support/catch.h"

#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/text.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Json report_of(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("render " + words + " -o with.png --report r.json");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(here.read("r.json"));
}

const Json& number(const Json& report, const std::string& name) {
  for (const Json& part : report["parts"]) {
    for (const Json& one : part["numbers"]) {
      if (one["number"] == name) return one;
    }
  }
  FAIL("no " << name);
  return report;
}

}  // namespace

TEST_CASE("a report changes no byte of the picture, and knows all stages with their times") {
  const WorkingDirectory here;
  for (const char* engine : {"tile", "staged"}) {
    const std::string words = std::string("room --size 160x90 --engine ") + engine;
    REQUIRE(here.run("render " + words + " -o without.png").exit_code == 0);
    const Json report = report_of(here, words);
    CHECK(here.read("with.png") == here.read("without.png"));
    CHECK(report["schema"] == "glassbox-report/1");
    CHECK(contains(report["engine"], engine));
    double ms = 0;
    for (const Json& part : report["parts"]) ms += part["ms"].get<double>();
    CHECK(ms > 0);
    const Json picture = number(report, "bytes of the picture");
    CHECK(picture["count"] == 160 * 90);
    CHECK(picture["unknown"] == 0);
    CHECK(picture["at_most"].get<double>() >= 0.4);
    CHECK(picture["half_below"].get<double>() <= picture["at_most"].get<double>());
    CHECK(number(report, "snapped corners")["at_most"].get<double>() >= 1.0 / 1024);
    CHECK(number(report, "texture samples")["at_most"].get<double>() > 0);
  }
}

TEST_CASE("the places of a report are commands that show them") {
  const WorkingDirectory here;
  const Json report = report_of(here, "room --size 160x90");
  int places = 0;
  for (const Json& part : report["parts"]) {
    for (const Json& one : part["numbers"]) {
      if (!one.contains("where")) continue;
      const std::string command = one["where"]["command"];
      const Outcome shown = here.run(command.substr(command.find(' ') + 1));
      INFO(command << ": " << shown.err);
      CHECK(shown.exit_code == 0);
      ++places;
    }
  }
  CHECK(places >= 8);
}

TEST_CASE("a depth format with fewer bits has a larger bound, by half of its step") {
  const WorkingDirectory here;
  const auto depth = [&](const std::string& format) {
    return number(report_of(here, "teapot --size 96x54 --depth " + format),
                  "stored depth")["at_most"]
        .get<double>();
  };
  const double fine = depth("d32"), coarse = depth("d16");
  CHECK(fine < 1e-5);
  CHECK(coarse > 0.4 / 65535);
  CHECK(coarse <= fine + 0.5 / 65535 * 1.001);
}

TEST_CASE("a report is a table, and says what it leaves out") {
  const WorkingDirectory here;
  const Outcome table = here.run("render forest --size 96x54 --samples 4 --report - -o x.png");
  REQUIRE(table.exit_code == 0);
  CHECK(contains(table.out, "fragments, "));
  CHECK(contains(table.out, "of distance"));
  CHECK(
      contains(unwrapped(table.out), "the 4 samples per pixel: all numbers are for pixel centres"));
  CHECK(contains(table.out, "glassbox pixel forest --size 96x54 --samples 4 --at "));
  REQUIRE(here.run("render forest --size 96x54 --samples 4 --report r.txt -o x.png").exit_code ==
          0);
  CHECK(contains(here.read("r.txt"), "bytes of the picture"));
  const Outcome normals = here.run("render cube --size 64x48 --show normal --report - -o x.png");
  CHECK(contains(normals.out, "another quantity"));
  CHECK_FALSE(contains(normals.out, "bytes of the picture"));
  const Outcome edges = here.run("render cube --size 64x48 --wireframe --report - -o x.png");
  REQUIRE(edges.exit_code == 0);
  CHECK(contains(edges.out, "stored bytes"));
  CHECK_FALSE(contains(edges.out, "unknown"));
}

TEST_CASE("a report of lines without normals has no normals, and no command for a line") {
  const WorkingDirectory here;
  here.write("line.obj", "v -1 0.1 0.9\nv 1 0.2 -0.9\nl 1 2\n");
  for (const char* near : {"", " --near 3"}) {  // the line whole, and clipped
    const Json report = report_of(here, std::string("line.obj --size 80x60") + near);
    CHECK(report["fragments_of_lines_and_points"].get<int>() > 10);
    CHECK(report["pixels_unknown"] == 0);
    for (const Json& part : report["parts"]) {
      for (const Json& one : part["numbers"]) {
        INFO(near << ": " << one["number"]);
        CHECK(one["unknown"] == 0);
        if (one["number"] == "normals") CHECK(one["count"] == 0);
        if (!one.contains("where")) continue;
        CHECK(one["where"].contains("pixel") == one["where"].contains("command"));
      }
    }
    CHECK(number(report, "bytes of the picture")["at_most"].get<double>() < 1);
  }
}

TEST_CASE("what a report cannot be asked for is refused in one line") {
  const WorkingDirectory here;
  check_refused(here.run("render room --stereo anaglyph --report r.json"),
                {"--report: it would be different for each eye", "--seen-by left"});
  check_refused(here.run("render room --frames 3 --turntable --report r.json"),
                {"--report: it would be different for each frame"});
  check_refused(here.run("render room -o - --report -"),
                {"--report -: the picture goes to standard output"});
  check_refused(here.run("render room -o x.png --json - --report -"),
                {"--report -: the JSON goes to standard output"});
  check_refused(here.run("render room -o x.png --report nowhere/r.json"),
                {"its directory does not exist"});
  check_refused(here.run("render room -o x.png --json r.json --report r.json"),
                {"two outputs would go to this file"});
  CHECK(here.names().empty());
}

}  // namespace glassbox::test
