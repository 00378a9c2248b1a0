// Tests glassbox stereo: its numbers agree with the planes that glassbox render writes, following
// its advice helps, and its page is complete.
#include "tests/support/catch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/working_directory.h"
#include "tests/support/manifest.h"

#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/mesh/gltf/write.h>

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Json stereo_report(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("stereo " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

Json row_of(const Json& report, const std::string& name) {
  for (const Json& row : report["parallax"]) {
    if (row["name"] == name) return row;
  }
  FAIL("no row " << name);
  return {};
}

Json verdict_of(const Json& report, const std::string& about) {
  for (const Json& verdict : report["verdicts"]) {
    if (verdict["about"] == about) return verdict;
  }
  FAIL("no verdict on " << about);
  return {};
}

Plane distances_of(const WorkingDirectory& here, const std::string& words, const std::string& eye) {
  const Outcome outcome =
      here.run("render " + words + " --seen-by " + eye + " -o p.png --depth-out d.pfm");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return parse_pfm(here.read("d.pfm"));
}

// Writes a scene with a road through a plain to the horizon in place of the forest's trees: the
// ground, sky, light and extent are the same.
void write_flat_road(const WorkingDirectory& here, const std::string& name) {
  Scene scene = *make_builtin("forest");
  std::erase_if(scene.instances, [&](const Instance& instance) {
    const std::string& mesh = scene.meshes[instance.mesh].name;
    return mesh == "trunk" || mesh == "crown";
  });
  for (Material& material : scene.materials) material.texture.reset();
  scene.textures.clear();
  scene.images.clear();
  Mesh road;
  road.name = "road";
  road.material = add_material(scene, "tar", {0.2f, 0.2f, 0.2f, 1});
  add_rectangle(road, {-3, 0.01, 64}, {6, 0, 0}, {0, 0, -192});
  add_object(scene, std::move(road));
  REQUIRE(write_glb(scene, here.file(name)));
}

}  // namespace

TEST_CASE(
    "the parallax of what is seen is that of the nearest and farthest pixels of both eyes "
    "(S0-11)") {
  const WorkingDirectory here;
  const std::string words = "room --size 96x64 --eye-separation 0.6 --window 3";
  const Json json = stereo_report(here, words);
  float nearest = INFINITY, farthest = 0;
  std::array<std::uint64_t, 2> beyond{};
  const double width = 96, budget = width * 0.03;
  for (const int eye : {0, 1}) {
    const Plane plane = distances_of(here, words, eye == 0 ? "left" : "right");
    for (const float distance : plane.values) {
      if (!std::isfinite(distance)) continue;
      nearest = std::min(nearest, distance);
      farthest = std::max(farthest, distance);
    }
  }
  // p(z) = k (1/f - 1/z), where k follows from the row of any other distance.
  const Json near = row_of(json, "near plane");
  const double k = near["px"].get<double>() / (1.0 / 3 - 1 / near["distance"].get<double>());
  const auto parallax = [&](double distance) { return k * (1.0 / 3 - 1 / distance); };
  for (const int eye : {0, 1}) {
    const Plane plane = distances_of(here, words, eye == 0 ? "left" : "right");
    for (const float distance : plane.values) {
      if (std::isfinite(distance))
        beyond[std::size_t(eye)] += std::abs(parallax(double(distance))) > budget;
    }
  }
  CHECK(row_of(json, "nearest seen")["distance"] == double(nearest));
  CHECK(row_of(json, "farthest seen")["distance"] == double(farthest));
  CHECK(std::abs(row_of(json, "nearest seen")["px"].get<double>() - parallax(double(nearest))) <
        1e-9);
  const Json& disparity = json["disparity"];
  CHECK(disparity["budget_in_front_px"] == budget);
  CHECK(disparity["left"]["too_near"].get<std::uint64_t>() +
            disparity["left"]["too_far"].get<std::uint64_t>() ==
        beyond[0]);
  CHECK(disparity["right"]["too_near"].get<std::uint64_t>() +
            disparity["right"]["too_far"].get<std::uint64_t>() ==
        beyond[1]);
  CHECK(beyond[0] > 0);
  const double pixels = double(json["disparity"]["left"]["drawn"].get<std::uint64_t>() +
                               json["disparity"]["right"]["drawn"].get<std::uint64_t>());
  CHECK(disparity["share_beyond_budget"] == double(beyond[0] + beyond[1]) / pixels);
  CHECK(verdict_of(json, "parallax")["level"] == "bad");
}

TEST_CASE("the report in words has what is seen beside the planes, and what to change as options") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("stereo forest --size 160x90 --eye-separation 1");
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  for (const char* words :
       {"forest, 160 x 90\n", "eyes 1 apart (as given)", "near plane", "nearest seen",
        "farthest seen", "above the budget in", "cut by the left or right edge",
        "toed in would have vertical parallax of up to", "mask anaglyph", "fit this order",
        "what to change\n", "--eye-separation 0."}) {
    INFO(words << " in\n" << outcome.out);
    CHECK(outcome.out.find(words) != std::string::npos);
  }
  for (std::size_t i = 0; i < outcome.out.size();) {
    const std::size_t end = outcome.out.find('\n', i);
    CHECK(end - i <= 100);
    i = end + 1;
  }
}

TEST_CASE(
    "who takes the advice has what is seen within the budget, or nothing cut before the window "
    "(S0-13)") {
  const WorkingDirectory here;
  const std::string picture = " --size 160x90";
  for (const std::string& scene : {std::string("forest"), std::string("room"),
                                   std::string("teapot"), std::string("teapot --ortho 6")}) {
    const Json first = stereo_report(here, scene + picture + " --eye-separation 1.5");
    int taken = 0;
    for (const Json& advice : first["advice"]) {
      const auto options = advice["options"].get<std::vector<std::string>>();
      if (options.empty() || options[0] != "--eye-separation") continue;
      std::string words = scene + picture;
      for (const std::string& option : options) words += " " + option;
      INFO(words << ": " << advice["text"]);
      const Json second = stereo_report(here, words);
      // Eyes in another place see other things at the sides of the old pictures: a few pixels at
      // most.
      CHECK(second["disparity"]["share_beyond_budget"] < 0.001);
      if (advice["text"].get<std::string>().starts_with("Move the window")) {
        // The objects that the edges then cut may be a little nearer than before.
        for (const Json& cut : second["window_violations"]) CHECK(cut["least_px"] > -2);
      }
      ++taken;
    }
    INFO(scene);
    CHECK(taken > 0);
  }
}

TEST_CASE("the forest gives more depth to see than a flat road of its extent (S0-16)") {
  const WorkingDirectory here;
  write_flat_road(here, "road.glb");
  const std::string words =
      " --size 320x180 --eye 0,1.7,0 --look-at 0,2.3,-12 --fov 45 --near 0.25 --window 12"
      " --eye-separation 0.1";
  const Json forest = stereo_report(here, "forest" + words),
             road = stereo_report(here, "road.glb" + words);
  CHECK(road["information"]["score"] > 0);  // its edges
  CHECK(forest["information"]["score"] > 10 * road["information"]["score"].get<std::uint64_t>());
  CHECK(road["information"]["pixels"].get<std::uint64_t>() > 320 * 180 * 9 / 10);
}

TEST_CASE(
    "skewed frusta have no vertical parallax, and cameras that are toed in have some (S0-07, "
    "C-75)") {
  const WorkingDirectory here;
  const Json json = stereo_report(here, "room --size 96x64 --eye-separation 0.4 --window 3");
  CHECK(json["vertical_parallax"]["skewed_px"] == 0);
  CHECK(json["vertical_parallax"]["toed_in_px"] > 0.5);
  const Json parallel = stereo_report(here, "teapot --size 96x64 --ortho 5 --eye-separation 0.4");
  CHECK(parallel["vertical_parallax"]["skewed_px"] == 0);
  CHECK(parallel["vertical_parallax"]["toed_in_px"] == 0);
  CHECK(parallel["eyes"]["projection"] == "parallel");
}

TEST_CASE("on a wall the eyes would have to diverge, and the advice is for the wall (C-72)") {
  const WorkingDirectory here;
  const std::string words = "forest --size 160x90 --eye-separation 0.5 --window 3 --budget 20";
  const Json desk = stereo_report(here, words + " --display 300,500");
  const Json wall = stereo_report(here, words + " --display 3000,4000");
  CHECK(verdict_of(desk, "divergence")["level"] == "good");
  CHECK(verdict_of(wall, "divergence")["level"] == "bad");
  CHECK(row_of(wall, "farthest seen")["display_mm"] > 65);
  REQUIRE(wall["advice"][0]["options"][0] == "--eye-separation");
  const Json better =
      stereo_report(here, "forest --size 160x90 --budget 20 --display 3000,4000 --eye-separation " +
                              wall["advice"][0]["options"][1].get<std::string>() + " --window 3");
  CHECK(verdict_of(better, "divergence")["level"] == "good");
}

TEST_CASE("colours that quarrel are named, with another method and other colours (S0-14, S0-15)") {
  const WorkingDirectory here;
  const Json json = stereo_report(here, "cube --size 64x64 --target-rivalry 0.02");
  CHECK(verdict_of(json, "rivalry")["level"] == "warning");
  const Json& anaglyph = json["anaglyph"];
  REQUIRE(anaglyph.contains("recolour"));
  CHECK(anaglyph["recolour"]["rivalry"] <= 0.02 + 1e-6);
  CHECK(anaglyph["recolour"]["curve"].size() > 2);
  CHECK(anaglyph["methods"].size() == 7);
  const Json dubois =
      stereo_report(here, "cube --size 64x64 --anaglyph dubois --glasses amber-blue");
  CHECK(dubois["anaglyph"]["methods"].size() < 7);
  CHECK(dubois["anaglyph"]["measured_lenses"] == false);
  const Json patient = stereo_report(here, "cube --size 64x64 --target-rivalry 1");
  CHECK(verdict_of(patient, "rivalry")["level"] == "good");
  CHECK_FALSE(patient["anaglyph"].contains("recolour"));
}

TEST_CASE("eyes in one place are said to be, and are told how far to go apart") {
  const WorkingDirectory here;
  const Json json = stereo_report(here, "teapot --size 96x64 --eye-separation 0");
  CHECK(json["eyes"]["passes"] == 1);
  CHECK(json["disparity"]["share_beyond_budget"] == 0);
  CHECK(json["window_violations"].empty());
  REQUIRE(json["advice"].size() >= 1);
  CHECK(json["advice"][0]["options"][0] == "--eye-separation");
  CHECK(std::stod(json["advice"][0]["options"][1].get<std::string>()) > 0);
}

TEST_CASE("pictures of nothing, and of one pixel, are reported on") {
  const WorkingDirectory here;
  const Json nothing =
      stereo_report(here, "teapot --size 64x48 --eye 0,0,50 --look-at 0,0,100 --html nothing.html");
  CHECK(verdict_of(nothing, "pictures")["level"] == "bad");
  CHECK(nothing["parallax"].size() == 3);
  CHECK(nothing["disparity"]["histogram"]["counts"].empty());
  CHECK(nothing["advice"].size() == 1);
  for (const std::string& size : {std::string("1x1"), std::string("1x9"), std::string("9x1")}) {
    INFO(size);
    const Json tiny = stereo_report(here, "room --size " + size + " --html tiny.html");
    CHECK(tiny["disparity"]["left"]["drawn"] > 0);
  }
  // The eye separation is as large as the picture is wide at the window.
  const Json enormous =
      stereo_report(here, "teapot --size 64x48 --eye-separation 6 --html big.html");
  CHECK(verdict_of(enormous, "parallax")["level"] == "bad");
}

TEST_CASE(
    "the page holds the report and its pictures, needs nothing else, and takes names for text") {
  const WorkingDirectory here;
  here.write("<img src=x>.obj", "v 0 0 0\nv 1 0 0\nv 0 1 -1\nf 1 2 3\n");
  const Outcome outcome = run_program(
      GLASSBOX_PROGRAM, {"stereo", "<img src=x>.obj", "--size", "64x48", "--html", "page.html"},
      here.path());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const std::string page = here.read("page.html");
  CHECK(page.find("content=\"default-src 'none'; img-src data:;") != std::string::npos);
  CHECK(page.find("http:") == std::string::npos);
  // The addresses in Chart.js are in lines of a comment, so no browser loads them.
  for (std::size_t at = page.find("https:"); at != std::string::npos;
       at = page.find("https:", at + 1)) {
    const std::size_t line = page.rfind('\n', at) + 1;
    INFO(page.substr(line, 80));
    CHECK(page.compare(line, 3, " * ") == 0);
  }
  CHECK(page.find("<img src=x>") == std::string::npos);
  const Json manifest = manifest_of(page);
  CHECK(manifest["scene"] == "<img src=x>.obj");
  for (const char* name : {"left", "right", "anaglyph", "disparity", "one_eye_left",
                           "one_eye_right", "rivalry", "ghosts", "information"}) {
    INFO(name);
    REQUIRE(manifest["pictures"].contains(name));
    const auto picture = manifest["pictures"][name].get<std::string>();
    CHECK(picture.starts_with("data:image/png;base64,iVBORw0KGgo"));
    CHECK(picture.size() > 100);
  }
  CHECK(here.names().size() == 2);
}

TEST_CASE("what the report cannot be about is refused in words, and nothing is written") {
  const WorkingDirectory here;
  struct Case {
    std::string words, cause;
  };
  for (const auto& [words, cause] :
       std::vector<Case>{{"teapot --budget -1", "is not a percentage"},
                         {"teapot --budget nan", "is not a percentage"},
                         {"teapot --budget 101", "is not a percentage"},
                         {"teapot --display 0,5", "is not possible"},
                         {"teapot --display 5", "--display"},
                         {"teapot --target-rivalry 2", "not between 0 and 1"},
                         {"teapot --seen-by left", "both eyes"},
                         {"teapot --eye-separation -1", "exchanges the eyes"},
                         {"teapot --eye-separation 1e9", ""},
                         {"teapot --window 1e-9", ""},
                         {"teapot --anaglyph optimised --glasses amber-blue", ""},
                         {"teapot --html page.txt", ".html"},
                         {"teapot --html nowhere/page.html", "nowhere"},
                         {"teapot --html a.html --json a.html", ""},
                         {"teapot --html a.html --size 16384x16384", "too large"},
                         {"no-such-thing", "no-such-thing"}}) {
    const Outcome outcome = here.run("stereo " + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(cause) != std::string::npos);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK(here.names().empty());
  }
}

TEST_CASE("the page's command line makes the same report again") {
  const WorkingDirectory here;
  REQUIRE(
      here.run("stereo cube --size 48x48 --anaglyph half --budget 2 --html page.html").exit_code ==
      0);
  const std::string page = here.read("page.html");
  CHECK(
      page.find("glassbox stereo cube --size 48x48 --anaglyph half --budget 2 --html page.html") !=
      std::string::npos);
}

}  // namespace glassbox::test
