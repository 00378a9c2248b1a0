// The condition numbers of scenes: each is found where it was planted, and `info` warns only of
// those whose effect is visible.
#include "study/stiffness/stiffness.h"

#include <algorithm>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/text.h"
#include "tests/app/working_directory.h"
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox::study {
namespace {

// `count` quads of side 2, one behind the other at a distance of `apart`.
Mesh stack_of_quads(int count, float apart) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto first = std::uint32_t(mesh.positions.size());
    const float z = float(-i) * apart;
    for (const auto& [x, y] : {std::pair{-1.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}}) {
      mesh.positions.push_back({x, y, z});
    }
    test::add_face(mesh, {first, first + 1, first + 2, first + 3});
  }
  return mesh;
}

View view_of(const Scene& scene, double near = 0.1) {
  Camera camera = test::camera_for(scene, 4.0 / 3);
  std::get<PerspectiveLens>(camera.lens).near = near;
  const auto view = make_view(camera, 160, 120);
  REQUIRE(view);
  return *view;
}

const ConditionNumber& number(const Stiffness& stiffness, const std::string& key) {
  const auto found = std::ranges::find(stiffness.numbers, key, &ConditionNumber::key);
  REQUIRE(found != stiffness.numbers.end());
  return *found;
}

}  // namespace

TEST_CASE("each condition number is worst where it was planted") {
  Mesh mesh = stack_of_quads(3, 0.5f);
  // A triangle a pixel wide and hardly high, in front of all quads.
  const auto first = std::uint32_t(mesh.positions.size());
  mesh.positions.push_back({-0.5f, 0, 0.2f});
  mesh.positions.push_back({0.5f, 0, 0.2f});
  mesh.positions.push_back({0.3f, 0.03f, 0.2f});
  test::add_face(mesh, {first, first + 1, first + 2});
  const Scene scene = test::scene_of(mesh);
  const Stiffness found = stiffness_of(scene, view_of(scene), {}, Vector<World, double>{0, 1, 0});
  CHECK(number(found, "sliver").place->triangle == 6);
  CHECK(number(found, "sliver").condition > 20);
  CHECK(number(found, "range-of-w").condition > 1);
  CHECK(number(found, "range-of-w").condition < 3);
  CHECK(number(found, "up").bound < 1e-9);
  for (const ConditionNumber& one : found.numbers) {
    CAPTURE(one.key, one.bound);
    CHECK_FALSE(one.is_above_limit());
    CHECK_FALSE(one.formula.empty());
    CHECK_FALSE(one.source.empty());
    CHECK_FALSE(one.advice.empty());
  }
  const Stiffness without_up = stiffness_of(scene, view_of(scene), {}, {});
  CHECK(without_up.numbers.size() == found.numbers.size() - 1);
}

TEST_CASE("depth passes only where a test of the picture depends on it") {
  // A single quad with the near plane at a ten-thousandth of its distance: there is nothing to
  // confuse it with.
  const Scene alone = test::scene_of(stack_of_quads(1, 0));
  RenderSettings settings;
  settings.depth = DepthFormat::kUnorm16;
  const ConditionNumber one =
      number(stiffness_of(alone, view_of(alone, 1e-4), settings, {}), "far-over-near");
  CHECK(*one.pixels > 1);
  CHECK(one.tests_in_doubt == 0);
  CHECK_FALSE(one.is_above_limit());
  const Scene pair = test::scene_of(stack_of_quads(2, 0.001f));
  const ConditionNumber two =
      number(stiffness_of(pair, view_of(pair, 1e-4), settings, {}), "far-over-near");
  CHECK(*two.tests_in_doubt > 1000);
  CHECK(two.is_above_limit());
  // With a suitable near plane the two are distinguished.
  const ConditionNumber kept =
      number(stiffness_of(pair, view_of(pair, 2), settings, {}), "far-over-near");
  CHECK_FALSE(kept.is_above_limit());
}

TEST_CASE("coordinates far from their origin are found by the vertex") {
  Mesh mesh = stack_of_quads(2, 0.5f);
  for (Point<Object>& p : mesh.positions) p.x += 3e6f;
  const Scene scene = test::scene_of(mesh);
  const ConditionNumber offset =
      number(stiffness_of(scene, view_of(scene), {}, {}), "offset-over-size");
  CHECK(offset.condition > 1e6);
  CHECK(offset.is_above_limit());
  REQUIRE(offset.place->position);
  CHECK(*offset.place->position < 4);  // of the nearer quad
}

}  // namespace glassbox::study

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

TEST_CASE("study stiffness prints, writes JSON and a page, and names the place for step") {
  const WorkingDirectory here;
  const Outcome text = here.run("study stiffness room --size 160x90 --json s.json --html s.html");
  REQUIRE(text.exit_code == 0);
  CHECK(contains(text.out, "far over near"));
  CHECK(contains(text.out, "bound 8 in docs/references.md"));
  const Json json = Json::parse(here.read("s.json"));
  CHECK(json["schema"] == "glassbox-stiffness/1");
  CHECK(json["numbers"].size() == 6);
  for (const Json& number : json["numbers"]) {
    const std::string command = number["worst"]["command"];
    const Outcome shown = here.run(command.substr(command.find(' ') + 1));
    INFO(command << ": " << shown.err);
    CHECK(shown.exit_code == 0);
  }
  CHECK(contains(here.read("s.html"), "far-over-near"));
  check_refused(here.run("study stiffness room --html s.png"), {"this output is a .html file"});
}

TEST_CASE("info warns of what can be seen, and of nothing else") {
  const WorkingDirectory here;
  for (const char* scene : {"teapot", "room", "forest", "checker", "thicket", "cube", "f-glyph"}) {
    const Outcome outcome = here.run(std::string("info ") + scene);
    INFO(outcome.out);
    CHECK_FALSE(contains(outcome.out, "warning:"));
    CHECK_FALSE(contains(outcome.out, "were not computed"));
  }
  CHECK(contains(here.run("info depth-ladder").out, "warning: far over near is 2.097e+06"));
  here.write("far.obj", "v 1000000.1 0 0\nv 1000001.2 0 0.1\nv 1000000.3 1.1 0\nf 1 2 3\n");
  const Outcome far = here.run("info far.obj");
  CHECK(contains(far.out, "warning: offset over size is 9.091e+05: errors of up to"));
  CHECK(contains(far.out, "put the offset into the node"));
  CHECK(Json::parse(here.run("info far.obj --json -").out)["stiffness"].size() == 1);
  CHECK(Json::parse(here.run("info cube --json -").out)["stiffness"].empty());
}

TEST_CASE("info does not follow millions of fragments that nobody asked for") {
  const WorkingDirectory here;
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf -3 -2 -1\n";
  here.write("deep.obj", text);
  const Outcome outcome = here.run("info deep.obj");
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.out,
                 "were not computed, because too many of its triangles cover each other"));
}

}  // namespace
}  // namespace glassbox::test
