// Tests what glassbox why, render, pixel and info say about a scene as a whole: the cause of an
// empty picture with a mend that works, z-fighting, and the sides of surfaces.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include <glassbox/mesh/builtin/scenes.h>

#include "tests/app/scenes.h"
#include "tests/app/text.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;
using Options = std::map<std::string, std::string>;

std::string words_of(const Options& options) {
  std::string words = " --size 96x64";
  for (const auto& [name, value] : options) words += " " + name + " " + value;
  return words;
}

Json why_json(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("why " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

// The options in a sentence: each word that begins with "--", with the word after it.
Options options_in(const std::string& sentence) {
  Options options;
  std::istringstream words(sentence);
  for (std::string word; words >> word;) {
    if (!word.starts_with("--")) continue;
    std::string value;
    words >> value;
    while (value.ends_with(';') || value.ends_with(',')) value.pop_back();
    options[word] = value;
  }
  return options;
}

// A built-in mesh as a file, with the given material and placement.
void write_cube(const WorkingDirectory& here, const std::string& name,
                void (*change)(Scene& scene)) {
  auto scene = make_builtin("cube");
  REQUIRE(scene);
  change(*scene);
  REQUIRE(write_glb(*scene, here.file(name)));
}

void turn_winding(Scene& scene) {
  for (const Face& face : scene.meshes[0].faces) {
    auto& corners = scene.meshes[0].corners;
    std::reverse(corners.begin() + face.first, corners.begin() + face.first + face.count);
  }
}

void mirror_node(Scene& scene) {
  scene.nodes[0].parent_from_node.at(0, 0) = -1;
  scene.nodes[0].world_from_node.at(0, 0) = -1;
}

TEST_CASE("the mend of the first cause brings the scene back") {
  const WorkingDirectory here;
  const std::pair<const char*, Options> cases[] = {
      {"near-plane", {{"--near", "50"}, {"--far", "60"}}},
      {"far-plane", {{"--near", "0.1"}, {"--far", "1"}}},
      {"behind", {{"--eye", "0,0,9"}, {"--look-at", "0,0,20"}}},
      {"looks-away", {{"--eye", "0,0,9"}, {"--look-at", "20,0,9"}}},
      {"looks-away", {{"--eye", "0,0,9"}, {"--look-at", "0,20,8"}}},
      {"inside", {{"--eye", "0.1,0.2,0"}, {"--look-at", "1,0,0"}}},
      {"too-small", {{"--eye", "0,0,9000"}, {"--look-at", "0,0,0"}}},
  };
  for (const auto& [cause, options] : cases) {
    const std::string words = "cube" + words_of(options);
    const Json found = why_json(here, words);
    CAPTURE(words, found.dump());
    REQUIRE_FALSE(found["causes"].empty());
    CHECK(found["causes"][0]["cause"] == cause);
    const Outcome text = here.run("why " + words);
    CHECK(contains(text.out, "  CAUSE  "));
    CHECK(contains(unwrapped(text.out), std::string(found["causes"][0]["why"])));
    Options mended = options_in(found["causes"][0]["mend"]);
    REQUIRE_FALSE(mended.empty());
    mended.insert(options.begin(), options.end());
    const Json after = why_json(here, "cube" + words_of(mended));
    CAPTURE(words_of(mended));
    CHECK(after["causes"].empty());
    CHECK(int(after["shown_pixels"]) > 100);
  }
}

TEST_CASE("a closed cube with alpha 0 is transparent, not turned away") {
  const WorkingDirectory here;
  write_cube(here, "clear.glb", [](Scene& scene) {
    scene.materials[0].alpha_mode = AlphaMode::kBlend;
    scene.materials[0].base_color.a = 0;
    for (Rgba& color : scene.meshes[0].colors) color.a = 0;
  });
  const Json found = why_json(here, "clear.glb --size 96x64");
  REQUIRE(found["causes"].size() == 1);
  CHECK(found["causes"][0]["cause"] == "transparent");
  CHECK_FALSE(contains(here.run("why clear.glb --size 96x64").out, "Most that are lost"));
}

TEST_CASE("a camera in a model in millimetres is inside it, not before backs") {
  const WorkingDirectory here;
  write_cube(here, "large.glb", [](Scene& scene) {
    for (Point<Object>& p : scene.meshes[0].positions) p = {p.x * 100, p.y * 100, p.z * 100};
  });
  const std::string words = "large.glb --size 96x64 --eye 0,0,5 --look-at 0,0,0";
  CHECK(why_json(here, words)["causes"][0]["cause"] == "inside");
  const std::string text = unwrapped(here.run("why " + words).out);
  CHECK(contains(text, "200 x 200 x 200 units large"));
  CHECK(contains(text, "millimetres"));
}

TEST_CASE("--check of why and render fails where nothing is seen, and only there") {
  const WorkingDirectory here;
  const std::string away = " --size 32x32 --eye 0,0,9 --look-at 0,0,20";
  CHECK(here.run("why cube --size 32x32 --check").exit_code == 0);
  CHECK(here.run("why cube" + away).exit_code == 0);
  CHECK(here.run("why cube --check" + away).exit_code == 1);
  CHECK(here.run("why cube --check --json -" + away).exit_code == 1);
  CHECK(here.run("why cube --size 320x180 --triangle 10 --check").exit_code == 0);
  CHECK(here.run("why cube --size 320x180 --triangle 0 --check").exit_code == 1);
  CHECK(here.run("render cube --size 32x32 --check -o a.png").exit_code == 0);
  CHECK(here.run("render cube -o b.png" + away).exit_code == 0);
  CHECK(here.run("render cube --check -o c.png" + away).exit_code == 1);
  CHECK((here.read("b.png") == here.read("c.png")));
  // A surface that fills the picture with one colour is seen.
  CHECK(here.run("render cube --size 32x32 --shade unlit --eye 0,0,1.5 --look-at 0,0,0 --check")
            .exit_code == 0);
  check_refused(here.run("render cube --frames 3 --turntable --check -o f.png"), {"--check"});
}

TEST_CASE("the note beside an empty picture names the cause, and no options that were not given") {
  const WorkingDirectory here;
  write_cube(here, "masked.glb", [](Scene& scene) {
    scene.materials[0].alpha_mode = AlphaMode::kMask;
    scene.materials[0].base_color.a = 0.25f;
  });
  const std::pair<const char*, const char*> cases[] = {
      {"render cube --size 32x32 --eye 0,0,9 --look-at 0,0,20", "behind the camera"},
      {"render cube --size 32x32 --near 50 --far 60", "near plane"},
      {"render masked.glb --size 32x32", "alpha test"},
  };
  for (const auto& [words, cause] : cases) {
    const Outcome outcome = here.run(words);
    CAPTURE(words, outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(contains(outcome.err, cause));
    CHECK_FALSE(contains(outcome.err, "without camera options"));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

TEST_CASE("OpenGL's planes are not mentioned where a near plane that was given cuts") {
  const WorkingDirectory here;
  for (const char* near : {"4.5", "5", "6", "8", "10"}) {
    const std::string words = std::string("why cube --size 320x180 --triangle 10 --far 20 --near ");
    CHECK_FALSE(contains(here.run(words + near).out, "E16"));
    CHECK_FALSE(contains(here.run(words + near).out, "OpenGL"));
  }
}

// ---- z-fighting ----

TEST_CASE("z-fighting is named with what to change, and the change ends it") {
  const WorkingDirectory here;
  const std::string ladder = "depth-ladder --size 320x180 --depth ";
  const Json coarse = why_json(here, ladder + "d16");
  REQUIRE_FALSE(coarse["depth_fights"].empty());
  CHECK(int(coarse["depth_fights"][0]["pixels"]) >= 8);
  const std::string text = unwrapped(here.run("why " + ladder + "d16").out);
  CHECK(contains(text, "z-fighting: triangle"));
  CHECK(contains(text, "--depth d24"));
  CHECK(why_json(here, ladder + "d32r")["depth_fights"].empty());
  const Json one = why_json(here, ladder + "d16 --triangle 52");
  REQUIRE_FALSE(one["depth_fights"].empty());
  for (const Json& fight : one["depth_fights"]) {
    CHECK((fight["triangles"][0] == 52 || fight["triangles"][1] == 52));
  }
  CHECK(contains(here.run("why " + ladder + "d16 --triangle 52").out, "z-fighting"));
  const Json fight = one["depth_fights"][0];
  const std::string at =
      " --at " + std::to_string(int(fight["at"][0])) + "," + std::to_string(int(fight["at"][1]));
  CHECK(contains(unwrapped(here.run("pixel " + ladder + "d16" + at).out), "z-fighting: triangle"));
  CHECK_FALSE(contains(here.run("pixel " + ladder + "d32r" + at).out, "z-fighting"));
}

TEST_CASE("surfaces in one plane need an offset; why and info say so") {
  const WorkingDirectory here;
  // Two rectangles in one oblique plane, with different corners.
  here.write("plane.obj",
             "v -3 -1 -3\nv 3 -1 -3\nv 3 1 3\nv -3 1 3\n"
             "v -2 -0.5 -1.5\nv 2 -0.5 -1.5\nv 2 0.5 1.5\nv -2 0.5 1.5\n"
             "o a\nf 1 2 3 4\no b\nf 5 6 7 8\n");
  for (const std::string command : {"why", "info"}) {
    const std::string size = command == "why" ? " --size 320x180" : "";
    const std::string text = unwrapped(here.run(command + " plane.obj" + size).out);
    CAPTURE(text);
    CHECK(contains(text, "z-fighting: triangle"));
    CHECK(contains(text, "offset"));
    CHECK(contains(text, "no depth format separates them"));
  }
}

TEST_CASE("no z-fighting is seen in built-in scenes") {
  const WorkingDirectory here;
  for (const std::string name : {"teapot", "room", "cube", "f-glyph", "checker", "thicket"}) {
    CAPTURE(name);
    CHECK(why_json(here, name + " --size 160x90")["depth_fights"].empty());
  }
}

// ---- the sides of surfaces ----

TEST_CASE("info and why find surfaces that are inside out, mirrored, or have wrong normals") {
  const WorkingDirectory here;
  write_cube(here, "right.glb", [](Scene&) {});
  write_cube(here, "inside-out.glb", turn_winding);
  write_cube(here, "mirrored.glb", mirror_node);
  write_cube(here, "both.glb", [](Scene& scene) {
    turn_winding(scene);
    mirror_node(scene);
  });
  const auto sphere = make_builtin("sphere");
  REQUIRE(sphere);
  Scene negated = *sphere, scaled = *sphere;
  for (Normal<Object>& n : negated.meshes[0].normals) n = {-n.x, -n.y, -n.z};
  for (Point<Object>& p : scaled.meshes[0].positions) p.y *= 3;
  for (Normal<Object>& n : scaled.meshes[0].normals) {
    const float length = std::sqrt(n.x * n.x + 9 * n.y * n.y + n.z * n.z);
    n = {n.x / length, 3 * n.y / length, n.z / length};
  }
  REQUIRE(write_glb(negated, here.file("negated.glb")));
  REQUIRE(write_glb(scaled, here.file("scaled.glb")));
  const std::pair<const char*, const char*> cases[] = {
      {"inside-out.glb",
       "its fronts are inside (its signed volume is -8, but its normals point outwards)"},
      {"mirrored.glb", "mirrors it (determinant -1)"},
      {"both.glb", "the winding was turned round in the mesh"},
      {"negated.glb", "its normals point to the backs of its faces"},
      {"scaled.glb", "as after a scale of (1, 3.0"},
  };
  for (const auto& [file, words] : cases) {
    for (const std::string command : {"info ", "why "}) {
      const std::string size = command == "why " ? " --size 96x64" : "";
      const Outcome outcome = here.run(command + file + size);
      CAPTURE(file, command, outcome.out);
      CHECK(contains(unwrapped(outcome.out), words));
      const Json json = Json::parse(here.run(command + file + size + " --json -").out);
      CHECK(json["surfaces"].size() == 1);
    }
  }
  CHECK(why_json(here, "right.glb --size 96x64")["surfaces"].empty());
  // A room is right for an eye inside it.
  write_cube(here, "room.glb", [](Scene& scene) {
    turn_winding(scene);
    for (Normal<Object>& n : scene.meshes[0].normals) n = {-n.x, -n.y, -n.z};
  });
  const std::string room = "room.glb --size 96x64 --eye ";
  CHECK(why_json(here, room + "0,0,0.5 --look-at 0,0,0")["surfaces"].empty());
  CHECK(why_json(here, room + "0,0,5 --look-at 0,0,0")["surfaces"].size() == 1);
}

}  // namespace
}  // namespace glassbox::test
