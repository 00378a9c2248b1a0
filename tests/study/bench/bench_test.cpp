// The command `glassbox bench`.
#include <tests/app/working_directory.h>
#include <tests/support/catch.h>
#include <tests/support/manifest.h>
#include <tests/support/skip.h>

#include <dlfcn.h>

#include <cstdio>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

namespace glassbox {
namespace {

using nlohmann::json;
using test::Outcome;
using test::WorkingDirectory;

bool mesa_is_here() {
  void* library = ::dlopen("libOSMesa.so.8", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return false;
  ::dlclose(library);
  return true;
}

TEST_CASE("bench writes machine, compiler, target and results as JSON") {
  const WorkingDirectory place;
  const Outcome run = place.run("bench S2 cube --size 64x36 --frames 4 --json -");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const json report = json::parse(run.out);
  for (const char* name : {"machine", "compiler", "target", "engine"}) {
    INFO(name);
    CHECK_FALSE(report.at(name).get<std::string>().empty());
  }
  CHECK(report.at("width") == 64);
  CHECK(report.at("height") == 36);
  CHECK(report.at("frames") == 4);
  std::set<std::string> scenes;
  for (const json& result : report.at("results")) {
    scenes.insert(result.at("scene"));
    CHECK(result.at("threads").get<int>() >= 1);
    const double ms = result.at("ms");
    CHECK(ms > 0);
    CHECK(result.at("ms_quartiles").at(0) <= ms);
    CHECK(result.at("ms_quartiles").at(1) >= ms);
    for (const char* name : {"peer", "peer_ms", "ratio"}) CHECK(result.at(name).is_null());
  }
  CHECK(scenes == std::set<std::string>{"S2", "cube"});
}

TEST_CASE("bench tells people what it tells programs, and writes the file as well") {
  const WorkingDirectory place;
  const Outcome run = place.run("bench s3 --size 64x36 --frames 1 --json out.json");
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("64 x 36") != std::string::npos);
  CHECK(run.out.find("S3 ") != std::string::npos);
  CHECK(json::parse(place.read("out.json")).at("results").at(0).at("scene") == "S3");
}

TEST_CASE("S6 reports the run that shares the eyes' work, S7 the rejection of whole objects") {
  const WorkingDirectory place;
  const Outcome run = place.run("bench S6 S7 --threads 1 --size 64x36 --frames 1 --json -");
  REQUIRE(run.exit_code == 0);
  const json results = json::parse(run.out).at("results");
  const json& stereo = results.at(0).at("stereo");
  CHECK(stereo.at("cost").get<double>() ==
        stereo.at("shared_ms").get<double>() / stereo.at("mono_ms").get<double>());
  CHECK(results.at(1).at("rejected_ms").get<double>() > 0);
}

TEST_CASE("bench refuses what it cannot measure, with a remedy") {
  const WorkingDirectory place;
  const auto refused = [&](const std::string& words, const std::string& says) {
    INFO(words);
    const Outcome run = place.run("bench " + words);
    INFO(run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK(run.err.find(says) != std::string::npos);
  };
  refused("S9", "S9");
  refused("R13", "R1, R2");
  refused("teapott", "teapot");
  refused("missing.glb", "missing.glb");
  refused("S1 --frames 0", "--frames");
  refused("S1 --threads 1,none", "--threads");
  refused("S1 --threads 0", "--threads");
  refused("S1 --size 0x4", "--size");
  refused("S1 --against itself", "mesa");
  refused("S3 --json no/such/place.json", "directory");
}

TEST_CASE("bench draws with either engine, and refuses threads for the one that has none") {
  const WorkingDirectory place;
  for (const char* words : {"--engine staged", "--target scalar", "--threads 2"}) {
    INFO(words);
    const Outcome run =
        place.run(std::string("bench S2 --size 64x36 --frames 1 --json - ") + words);
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(json::parse(run.out).at("results").size() >= 1);
  }
  CHECK(place.run("bench S2 --engine staged --threads 2").exit_code == 2);
}

TEST_CASE("two points give the ratio of their times, and no law is fitted to them") {
  const WorkingDirectory here;
  const auto run =
      here.run("bench --scaling triangles --most 3000 --size 64x36 --frames 1 --json s.json");
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find(" times as many triangles take ") != std::string::npos);
  CHECK(run.out.find("time grows as") == std::string::npos);
  const json scaling = json::parse(here.read("s.json")).at("scaling").at(0);
  const json& points = scaling.at("points");
  REQUIRE(points.size() == 2);
  CHECK_FALSE(scaling.contains("exponent"));
  CHECK_FALSE(scaling.contains("bend"));
  const auto ratio = [&](const char* of) {
    return points.at(1).at(of).get<double>() / points.at(0).at(of).get<double>();
  };
  CHECK(scaling.at("ratios").at("x") == ratio("x"));
  CHECK(scaling.at("ratios").at("ms") == ratio("ms"));
}

TEST_CASE("scaling reports every point up to --most, and what a triangle takes") {
  const WorkingDirectory place;
  const Outcome run = place.run(
      "bench --scaling triangles --most 10000 --size 64x36 --frames 1 --json - --html page.html");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const json scaling = json::parse(run.out).at("scaling").at(0);
  CHECK(scaling.at("by") == "triangles");
  REQUIRE(scaling.at("points").size() == 3);
  for (const json& point : scaling.at("points")) CHECK(point.at("ms").get<double>() > 0);
  CHECK(scaling.at("exponent").is_number());
  const std::string page = place.read("page.html");
  CHECK(page.find("http:") == std::string::npos);
  json shown = test::manifest_of(page).at("scaling").at(0);
  CHECK(shown.at("told").get<std::string>().starts_with("time grows as triangles^"));
  shown.erase("told");
  CHECK(shown == scaling);
}

TEST_CASE(
    "the page has the times that it draws, the floor's beside them, and no peer of which none was "
    "asked") {
  const WorkingDirectory place;
  const Outcome run = place.run(
      "bench S2 cube --threads 1 --floor --size 64x36 --frames 1 --json - --html page.html");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const std::string page = place.read("page.html");
  const json shown = test::manifest_of(page);
  CHECK(shown == json::parse(run.out));
  REQUIRE(shown.at("results").size() == 2);
  for (const json& result : shown.at("results")) {
    CHECK(result.at("ms").get<double>() > 0);
    CHECK(result.at("floor_ms").get<double>() > 0);
    CHECK(result.at("peer") == nullptr);
    CHECK(result.at("ratio") == nullptr);
  }
}

TEST_CASE("a path is written out in the numbers of the page") {
  const WorkingDirectory place;
  const std::string name = std::string(50, 'u') + "-the-end.obj";
  place.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  REQUIRE(
      place.run("bench " + name + " --threads 1 --size 64x36 --frames 1 --html p.html").exit_code ==
      0);
  const std::string page = place.read("p.html");
  CHECK(test::manifest_of(page).at("results").at(0).at("scene") == name);
  CHECK(page.find(name + " ") != std::string::npos);
}

TEST_CASE("the floor is above nothing and the scene's bytes are those of its tables") {
  const WorkingDirectory place;
  const Outcome run = place.run("bench S4bf --floor --threads 1 --size 64x36 --frames 1 --json -");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const json report = json::parse(run.out);
  CHECK(report.at("floor").at(0).at("read_bytes_per_second").get<double>() > 0);
  const json& result = report.at("results").at(0);
  CHECK(result.at("floor_ms").get<double>() > 0);
  // 256 vertices with a position and a colour, 384 indices; 64 x 36 pixels with a colour and a
  // depth.
  CHECK(result.at("least_bytes_read") == 256 * (12 + 16) + 384 * 4);
  CHECK(result.at("least_bytes_written") == 64 * 36 * 8);
}

TEST_CASE("Mesa draws the same pictures") {
  if (!mesa_is_here()) SKIP_TEST("no libOSMesa.so.8 (Debian: libosmesa6)");
  const WorkingDirectory place;
  const Outcome run = place.run(
      "bench S1 S2 S3 S4bf S4fb S5 S6 S7 --against mesa --threads 2 --size 480x270 --frames 1 "
      "--json - --html page.html");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const json results = json::parse(run.out).at("results");
  CHECK(test::manifest_of(place.read("page.html")).at("results") == results);
  REQUIRE(results.size() == 8);
  for (const json& result : results) {
    INFO(result.dump(2));
    CHECK(result.at("peer").get<std::string>().find("llvmpipe") != std::string::npos);
    CHECK(result.at("ratio").get<double>() ==
          result.at("peer_ms").get<double>() / result.at("ms").get<double>());
    const json& pictures = result.at("pictures");
    CHECK(pictures.at("same") == true);
    CHECK(pictures.at("largest_elsewhere").get<int>() <= 2);
    CHECK((pictures.at("covered").get<int>() > 0) == (result.at("scene") != "S7"));
  }
}

TEST_CASE("Mesa draws the same pictures of built-in scenes, with samples and for two eyes") {
  if (!mesa_is_here()) SKIP_TEST("no libOSMesa.so.8 (Debian: libosmesa6)");
  const WorkingDirectory place;
  for (const char* words : {"cube sphere f-glyph room thicket R9 R12", "cube R6 --samples 4",
                            "teapot:8 R7 --stereo anaglyph"}) {
    INFO(words);
    const Outcome run = place.run("bench " + std::string(words) +
                                  " --against mesa --threads 1 --size 320x180 --frames 1 --json -");
    INFO(run.err);
    INFO(run.out);
    REQUIRE(run.exit_code == 0);
    const json report = json::parse(run.out);
    for (const json& result : report.at("results")) {
      CHECK(result.at("peer").get<std::string>().find("llvmpipe") != std::string::npos);
      CHECK(result.at("pictures").at("covered").get<int>() > 0);
    }
  }
}

TEST_CASE("what the peer cannot do is drawn alone, and the reason is told") {
  const WorkingDirectory place;
  place.write("line.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n");
  const Outcome run = place.run(
      "bench cube line.obj --samples 8 --against mesa --threads 1 --size 64x36 --frames 1 --json "
      "b.json");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("cube is drawn without the peer: ") != std::string::npos);
  CHECK(run.out.find("line.obj is drawn without the peer: ") != std::string::npos);
  const json report = json::parse(place.read("b.json"));
  CHECK(report.at("notes").size() == 2);
  for (const json& result : report.at("results")) {
    CHECK(result.at("samples") == 8);
    CHECK(result.at("ratio").is_null());
  }
}

TEST_CASE(
    "the real scenes have their names and samples, and one whose file is missing is left out") {
  const WorkingDirectory place;
  const Outcome run = place.run(
      "bench R1 r2 R3 R4 R5 R6 R7 R8 R9 R10 R11 R12 --threads 1 --size 64x36 --frames 1 --json -");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const json report = json::parse(run.out);
  std::set<std::string> scenes;
  for (const json& result : report.at("results")) {
    const std::string scene = result.at("scene");
    scenes.insert(scene);
    CHECK(result.at("samples") == (scene == "R6" || scene == "R7" ? 4 : 1));
  }
  // The directory where the tests run has no ../shared/assets.
  CHECK(scenes ==
        std::set<std::string>{"R1", "R2", "R3", "R4", "R6", "R7", "R8", "R9", "R10", "R11", "R12"});
  CHECK(report.at("notes").at(0).get<std::string>().starts_with("R5 is left out: "));
}

TEST_CASE("--samples takes what the program draws, --stereo an anaglyph") {
  const WorkingDirectory place;
  CHECK(place.run("bench cube --samples 3").exit_code == 2);
  CHECK(place.run("bench cube --stereo side-by-side").exit_code == 2);
  const Outcome run = place.run(
      "bench cube S2 --samples 16 --stereo anaglyph --threads 1 --size 64x36 --frames 1 --json -");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const json report = json::parse(run.out);
  for (const json& result : report.at("results")) {
    CHECK(result.at("samples") == 16);
    CHECK(result.at("stereo").at("shared_ms").get<double>() > 0);
  }
}

}  // namespace
}  // namespace glassbox
