// Tests glassbox render --frames --path: pictures along a camera path, and an eye separation that
// adapts to each frame.
#include "tests/support/catch.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <glassbox/images/png_text.h>
#include <glassbox/images/read.h>
#include <glassbox/images/recipe.h>

#include "tests/app/text.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

std::string path_of(const std::string& keyframes, const std::string& more = "") {
  return "{\"camera_path\": 1, " + more + "\"keyframes\": [" + keyframes + "]}";
}

const std::string kSmoothWalk = path_of(
    R"({"time": 0, "eye": [0, 2, 14], "look_at": [0, 1.5, 0]},
       {"time": 1, "eye": [3, 1.6, 6], "look_at": [0, 1.5, -2]},
       {"time": 3, "eye": [-1, 1.6, 2], "look_at": [0, 1.5, -6]})",
    R"("interpolation": "smooth", )");

// The window jumps from 10 to 1 (C-79) and later to 5. At each jump, the farthest visible point
// sets the limit of the separation, which then changes in one direction only.
const std::string kJump = path_of(
    R"({"frame": 1, "eye": [0, 2, 14], "look_at": [0, 1.5, 0], "window": 10},
       {"frame": 8, "eye": [0, 2, 14], "look_at": [0, 1.5, 0], "window": 10},
       {"frame": 9, "eye": [0, 2, 14], "look_at": [0, 1.5, 0], "window": 1},
       {"frame": 16, "eye": [0, 2, 14], "look_at": [0, 1.5, 0], "window": 1},
       {"frame": 17, "eye": [0, 2, 14], "look_at": [0, 1.5, 0], "window": 5})");

// A walk through a room, close to the objects in it.
const std::string kRoom = path_of(
    R"({"time": 0, "eye": [3, 1, -0.5], "look_at": [0, -1, -8]},
       {"time": 1, "eye": [0, 0, -5], "look_at": [0, -1, -9]})");

std::string frames(const std::string& scene, int count, const std::string& options) {
  return "render " + scene + " --size 96x64 --frames " + std::to_string(count) +
         " --path p.json -o f.png " + options;
}

Json frames_report(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run(words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

// ---- comfort ----

TEST_CASE("measured parallax keeps the budget in every frame, and steps keep their bound (S0-13)") {
  double largest_step = 0;
  for (const auto& [scene, path] : std::vector<std::pair<std::string, std::string>>{
           {"forest", kSmoothWalk}, {"forest", kJump}, {"room", kRoom}}) {
    for (const std::string options :
         {"--stereo pair", "--stereo anaglyph --parallax-budget 1,2 --max-step 0.003",
          "--stereo interlaced --parallax-budget 0.5 --release-frames 3"}) {
      const WorkingDirectory here;
      here.write("p.json", path);
      const Json json = frames_report(here, frames(scene, 24, options));
      const Json& stereo = json["stereo"];
      INFO(scene << " " << options << " " << stereo.dump());
      REQUIRE(json["frames"].size() == 24);
      double last = json["frames"][0]["separation"];
      for (const Json& frame : json["frames"]) {
        CHECK(frame["in_front_px"] <= stereo["budget_px"][0]);
        CHECK(frame["behind_px"] <= stereo["budget_px"][1]);
        const double separation = frame["separation"];
        CHECK(separation > 0);
        CHECK(separation <= stereo["separation_bound"].get<double>());
        // The step may exceed its bound by one rounding of a sum of this size.
        const double step = std::abs(separation - last);
        CHECK(step <= stereo["step_bound"].get<double>() + 0x1p-52 * std::max(separation, last));
        last = separation;
      }
      largest_step = std::max(largest_step, stereo["largest_step"].get<double>());
    }
  }
  CHECK(largest_step > 0.01);
}

TEST_CASE("where the window jumps, the separation falls and rises once, without overshoot (C-79)") {
  const WorkingDirectory here;
  here.write("p.json", kJump);
  const Json json = frames_report(here, frames("forest", 40, "--stereo pair --release-frames 3"));
  std::vector<double> separations;
  for (const Json& frame : json["frames"]) separations.push_back(frame["separation"]);
  const auto least = std::ranges::min_element(separations);
  CHECK(*least < separations.front() / 3);
  CHECK(std::is_sorted(separations.begin(), least + 1, std::greater<>()));
  CHECK(std::is_sorted(least, separations.end()));
  CHECK(separations.back() > 2 * *least);
}

TEST_CASE("a budget of nothing gives the mono picture in both eyes; --eye-separation is the most") {
  const WorkingDirectory here;
  here.write("p.json", kSmoothWalk);
  const Json flat =
      frames_report(here, frames("forest", 3, "--stereo anaglyph --parallax-budget 0"));
  for (const Json& frame : flat["frames"]) CHECK(frame["separation"] == 0.0);
  const auto anaglyph = read_image(here.file("f-0002.png"));
  const Json mono = frames_report(here, frames("forest", 3, ""));
  CHECK_FALSE(mono.contains("stereo"));
  CHECK(anaglyph.value() == read_image(here.file("f-0002.png")).value());

  const Json capped =
      frames_report(here, frames("forest", 3, "--stereo pair --eye-separation 0.01"));
  for (const Json& frame : capped["frames"]) CHECK(frame["separation"] <= 0.01);
}

// ---- pictures ----

TEST_CASE("a frame's recipe makes the frame as a single picture") {
  for (const std::string options : {"--stereo anaglyph", "--stereo over-under --shade flat", ""}) {
    const WorkingDirectory here;
    here.write("p.json", kSmoothWalk);
    REQUIRE(here.run(frames("forest", 5, options)).exit_code == 0);
    const std::string bytes = here.read("f-0004.png");
    const auto text = read_png_text(std::as_bytes(std::span(bytes)));
    REQUIRE(text);
    const auto recipe = recipe_of(*text);
    REQUIRE(recipe);
    std::string words = "render " + recipe->scene + " -o single.png";
    for (const std::string& word : recipe->options) words += " " + word;
    INFO(words);
    REQUIRE(here.run(words).exit_code == 0);
    CHECK(read_image(here.file("single.png")).value() ==
          read_image(here.file("f-0004.png")).value());
  }
}

TEST_CASE("frames are numbered after the name, where the pattern says, or in a directory") {
  const WorkingDirectory here;
  here.write("p.json", kSmoothWalk);
  std::filesystem::create_directory(here.file("shots"));
  const std::string words = "render cube --size 8x8 --frames 2 --path p.json";
  for (const auto& [options, name] :
       std::vector<std::pair<std::string, std::string>>{{"", "cube-0002.png"},
                                                        {" -o a.b.ppm", "a.b-0002.ppm"},
                                                        {" -o x%03dy.png", "x002y.png"},
                                                        {" -o %d%%.png", "2%.png"},
                                                        {" -o shots", "shots/cube-0002.png"},
                                                        {" -o shots/%04d.png", "shots/0002.png"}}) {
    INFO(options);
    CHECK(here.run(words + options).exit_code == 0);
    CHECK(std::filesystem::exists(here.file(name)));
  }
  const Outcome fewer = here.run("render cube --size 8x8 --frames 1 --path p.json");
  CHECK(contains(fewer.err, "cube-0002.png is there from an earlier, longer sequence"));
}

TEST_CASE("the first and the last frame are the first and the last keyframe; fov and up count") {
  const WorkingDirectory here;
  here.write("p.json", path_of(R"({"time": 5, "eye": [4, 3, 8], "look_at": [0, 1, 0], "fov": 30},
                        {"time": 9, "eye": [-4, 5, 8], "look_at": [0, 0, 0], "up": [1, 1, 0],
                         "fov": 70})"));
  REQUIRE(here.run(frames("teapot:2", 3, "")).exit_code == 0);
  const auto single = [&](const std::string& camera) {
    REQUIRE(here.run("render teapot:2 --size 96x64 -o s.png " + camera).exit_code == 0);
    return read_image(here.file("s.png")).value();
  };
  CHECK(read_image(here.file("f-0001.png")).value() ==
        single("--eye 4,3,8 --look-at 0,1,0 --fov 30"));
  CHECK(read_image(here.file("f-0002.png")).value() ==
        single("--eye 0,4,8 --look-at 0,0.5,0 --up 0.5,1,0 --fov 50"));
  CHECK(read_image(here.file("f-0003.png")).value() ==
        single("--eye -4,5,8 --look-at 0,0,0 --up 1,1,0 --fov 70"));
}

TEST_CASE("the plot tells its numbers in words and as lines of as many points as frames") {
  const WorkingDirectory here;
  here.write("p.json", kSmoothWalk);
  const Outcome outcome = here.run(frames("forest", 7, "--stereo pair --parallax-budget 2,1"));
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "plot: f.svg"));
  const std::string svg = here.read("f.svg");
  CHECK(contains(svg, "<title id=\"title\">Comfort of forest along p.json</title>"));
  CHECK(contains(svg, "Over 7 frames"));
  CHECK(contains(svg, "budget 2 %"));
  CHECK(contains(svg, "budget 1 %"));
  CHECK(contains(svg, "prefers-color-scheme: dark"));
  int lines = 0;
  for (std::size_t at = svg.find("points=\""); at != std::string::npos;
       at = svg.find("points=\"", at + 1)) {
    const std::string points = svg.substr(at + 8, svg.find('"', at + 8) - at - 8);
    CHECK(std::ranges::count(points, ',') == 7);
    ++lines;
  }
  CHECK(lines == 4);
  CHECK(here.run(frames("forest", 1, "--stereo pair --plot one.svg")).exit_code == 0);
  CHECK(contains(here.read("one.svg"), "<circle"));
}

// ---- bad input ----

TEST_CASE("a path that is none is refused with the place that is wrong") {
  const WorkingDirectory here;
  const std::string eye = R"("eye": [0, 1, 5], "look_at": [0, 0, 0])";
  const std::string a = "{\"time\": 0, " + eye + "}";
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"", {"line 1"}},
      {"[1, 2", {"line 1", "not valid JSON"}},
      {"{\n \"camera_path\": 1,\n oops}", {"line 3, column 2", "not valid JSON"}},
      {"{}", {"not a camera path"}},
      {"{\"camera_path\": 2}", {"camera_path", "version"}},
      {"{\"camera_path\": 1}", {"keyframes", "none"}},
      {path_of(""), {"keyframes", "none"}},
      {path_of(a, "\"interpolation\": \"cubic\", "), {"interpolation", "smooth"}},
      {path_of(a, "\"speed\": 1, "), {"'speed'", "the keys are"}},
      {path_of(a, "\"camera_path\": 1, "), {"'camera_path' occurs twice"}},
      {path_of(a + ", 7"), {"keyframe 2", "not a JSON object"}},
      {path_of("{" + eye + "}"), {"keyframe 1", "\"time\""}},
      {path_of("{\"frame\": 0, " + eye + "}"), {"keyframe 1", "\"frame\"", "is 0"}},
      {path_of("{\"frame\": 1.5, " + eye + "}"), {"\"frame\"", "whole number"}},
      {path_of(a + ", {\"frame\": 4, " + eye + "}"), {"keyframe 2, \"frame\""}},
      {path_of(a + ", {\"time\": 0, " + eye + "}"), {"keyframe 2, \"time\"", "in order"}},
      {path_of(a + ", {\"time\": -1, " + eye + "}"), {"keyframe 2, \"time\"", "in order"}},
      {path_of("{\"time\": 0, \"look_at\": [0,0,0]}"), {"keyframe 1", "no \"eye\""}},
      {path_of("{\"time\": 0, \"eye\": [1, 2], \"look_at\": [0,0,0]}"),
       {"keyframe 1, \"eye\"", "three numbers"}},
      {path_of("{\"time\": 0, \"eye\": [1, \"2\", 3], \"look_at\": [0,0,0]}"),
       {"keyframe 1, \"eye\"", "not a number"}},
      {path_of("{\"time\": 0, \"eye\": [1, 2, 1e39], \"look_at\": [0,0,0]}"),
       {"keyframe 1, \"eye\"", "1e+39"}},
      {path_of("{\"time\": 0, \"eye\": [1, 2, 1e999], \"look_at\": [0,0,0]}"), {"too large"}},
      {path_of("{\"time\": 0, \"eye\": [1, 2, 3], \"look_at\": [1, 2, 3]}"), {"keyframe 1"}},
      {path_of("{\"time\": 0, " + eye + ", \"up\": [0, 0, 0]}"), {"keyframe 1"}},
      {path_of("{\"time\": 0, " + eye + ", \"fov\": 180}"), {"keyframe 1, \"fov\"", "180"}},
      {path_of("{\"time\": 0, " + eye + ", \"window\": 0}"), {"keyframe 1, \"window\""}},
      {path_of("{\"time\": 0, " + eye + ", \"window\": \"far\"}"), {"\"window\"", "\"auto\""}},
      {path_of("{\"time\": 0, " + eye + ", \"fov\": 40}, {\"time\": 1, " + eye + "}"),
       {"keyframe 2, \"fov\"", "all keyframes or in none"}},
      {path_of("[[[[[[1]]]]]]"), {"nested"}}};
  const std::string words = "render cube --size 8x8 --frames 2 --path p.json";
  for (const auto& [text, parts] : cases) {
    here.write("p.json", text);
    INFO(text);
    std::vector<std::string> all = parts;
    all.push_back("p.json");
    check_refused(here.run(words), all);
  }
  std::string many = a;
  for (int i = 1; i <= 10000; ++i) many += ",{\"time\":" + std::to_string(i) + "," + eye + "}";
  here.write("p.json", path_of(many));
  check_refused(here.run(words), {"10001", "10000 or fewer"});
  check_refused(here.run("render cube --frames 2 --path nowhere.json"), {"nowhere.json"});
  CHECK(here.names().size() == 1);
}

TEST_CASE("options of frames that make no sense are refused") {
  const WorkingDirectory here;
  here.write("p.json", kSmoothWalk);
  here.write("w.json", kJump);
  here.write("cross.json", path_of(R"({"time": 0, "eye": [0, 0, 5], "look_at": [0, 0, 0]},
                                      {"time": 1, "eye": [0, 0, 0], "look_at": [0, 0, 5]})"));
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"--frames 2", {"--frames", "--path"}},
      {"--path p.json", {"--path", "--frames"}},
      {"--frames 0 --path p.json", {"--frames", "'0'", "100000"}},
      {"--frames -3 --path p.json", {"--frames", "'-3'"}},
      {"--frames 1e3 --path p.json", {"--frames", "'1e3'"}},
      {"--frames 99999999999 --path p.json", {"--frames"}},
      {"--frames 2 --path p.json --plot x.svg", {"--plot", "--stereo"}},
      {"--frames 2 --path p.json --parallax-budget 3", {"--parallax-budget", "--stereo"}},
      {"--parallax-budget 3 --stereo pair", {"--parallax-budget", "--frames"}},
      {"--frames 2 --path p.json --stereo pair --parallax-budget -1", {"0 to 100"}},
      {"--frames 2 --path p.json --stereo pair --parallax-budget nan", {"0 to 100"}},
      {"--frames 2 --path p.json --stereo pair --max-step 0", {"--max-step", "above 0"}},
      {"--frames 2 --path p.json --stereo pair --release-frames -1", {"--release-frames"}},
      {"--frames 2 --path p.json --stereo pair --plot x.png", {"x.png", ".svg"}},
      {"--frames 2 --path p.json --eye 0,0,5", {"--eye", "path"}},
      {"--frames 2 --path p.json --camera 0", {"--camera", "path"}},
      {"--frames 2 --path p.json --seen-by left", {"--seen-by"}},
      {"--frames 2 --path p.json --eye-separation 1", {"--eye-separation", "--stereo"}},
      {"--frames 2 --path p.json --stereo pair --eye-separation -1", {"--eye-separation", "-1"}},
      {"--frames 2 --path p.json --stereo pair --window inf", {"--window", "--eye-separation"}},
      {"--frames 2 --path w.json --stereo pair --window 5", {"--window", "keyframes"}},
      {"--frames 2 --path p.json --depth-out d.pfm", {"--depth-out"}},
      {"--frames 2 --path p.json --stats", {"--stats"}},
      {"--frames 2 --path p.json -o a%sb.png", {"a%sb.png", "%04d"}},
      {"--frames 2 --path p.json -o a%d%d.png", {"two places"}},
      {"--frames 2 --path p.json -o a%%.png", {"no place"}},
      {"--frames 2 --path p.json -o x.bmp", {".png or .ppm"}},
      {"--frames 2 --path p.json -o nowhere/x.png", {"nowhere", "directory"}},
      {"--frames 2 --path p.json --json cube-0002.png", {"two outputs"}},
      {"--frames 3 --path cross.json", {"frame 2"}}};
  const auto before = here.names();
  for (const auto& [options, parts] : cases) {
    INFO(options);
    check_refused(here.run("render cube --size 8x8 " + options), parts);
  }
  CHECK(here.names() == before);
}

TEST_CASE("a camera that sees nothing, stands in a wall or does not move is told") {
  const WorkingDirectory here;
  const auto said = [&](const std::string& path) {
    here.write("p.json", path);
    const Outcome outcome = here.run(frames("room", 3, "--stereo pair"));
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    return outcome.err;
  };
  CHECK(contains(said(path_of(R"({"time": 0, "eye": [90, 1, 0], "look_at": [99, 1, 0]},
                                 {"time": 1, "eye": [91, 1, 0], "look_at": [99, 1, 0]})")),
                 "no part of the scene is in view in 3 frames"));
  CHECK(contains(said(path_of(R"({"time": 0, "eye": [1, 1.5, 1], "look_at": [0, 0.6, 0]})")),
                 "one keyframe: the camera stands still"));
}

}  // namespace
}  // namespace glassbox::test
