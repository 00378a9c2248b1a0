// Tests glassbox info: the contents of a scene, and what is wrong with it.
#include "tests/support/catch.h"

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/text.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Json info(const WorkingDirectory& here, const std::string& scene) {
  const Outcome outcome = here.run("info " + scene + " --json -");
  INFO(scene << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

TEST_CASE("a closed cube is described and nothing is wrong with it") {
  const WorkingDirectory here;
  const Json json = info(here, "cube");
  CHECK(json["scene"] == "cube");
  CHECK(json["instances"] == 1);
  CHECK(json["triangles"] == 12);
  CHECK(json["lines"] == 0);
  CHECK(json["points"] == 0);
  CHECK(json["bounds"]["low"] == Json({-1, -1, -1}));
  CHECK(json["bounds"]["high"] == Json({1, 1, 1}));
  const Json mesh = json["meshes"][0];
  CHECK(mesh["faces"] == 6);
  CHECK(mesh["vertices"] == 8);
  CHECK(mesh["edges"] == 12);
  CHECK(mesh["euler_characteristic"] == 2);
  CHECK(mesh["genus"] == 0);
  CHECK(mesh["closed"] == true);
  CHECK(mesh["area"] == 24);
  CHECK(mesh["findings"].empty());
  CHECK(json["materials"].size() == 1);

  const Outcome text = here.run("info cube");
  CHECK(contains(text.out, "1 instance of 1 mesh: 12 triangles, 0 lines, 0 points"));
  CHECK(contains(text.out,
                 "6 faces, 8 vertices, 12 edges, 1 component, Euler characteristic 2, closed"));
}

TEST_CASE("a file without materials has one called default") {
  const WorkingDirectory here;
  here.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  REQUIRE(here.run("info m.obj --write m.glb").exit_code == 0);
  for (const char* file : {"m.obj", "m.glb"}) {
    const Json materials = info(here, file)["materials"];
    INFO(file);
    REQUIRE(materials.size() == 1);
    CHECK(materials[0]["name"] == "default");
  }
}

TEST_CASE("what is wrong with a mesh is found, counted and said") {
  struct Case {
    const char* what;
    const char* obj;
    const char* field;
    int count;
    const char* phrase;
  };
  const std::vector<Case> cases{
      {"a lone triangle is open", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "open_edges", 3,
       "3 open edges"},
      {"two triangles that turn differently",
       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n", "inconsistent_edges", 1,
       "1 edge where the winding changes"},
      {"three faces at one edge",
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
       "non_manifold_edges", 1, "1 edge with more than two faces"},
      {"a bent quad", "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\n", "non_planar_faces", 1,
       "1 bent face (the worst is face 0"},
      {"a face on a line", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n",
       "degenerate_faces", 1, "1 face without area"},
      {"the same face twice", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 3 1\n", "duplicate_faces", 1,
       "1 duplicate face"},
      {"an outline that crosses itself",
       "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 -1 0\nv 0 3 0\nf 1 2 3 4 5\n", "self_intersecting_faces", 1,
       "1 face that crosses itself"},
      {"a quad whose corners are listed row by row",
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3 4\nf 1 2 4 3\n", "quads_in_z_order", 1,
       "1 quad in Z order (proper if the last two corners are exchanged)"}};
  for (const Case& c : cases) {
    const WorkingDirectory here;
    here.write("m.obj", c.obj);
    const Json mesh = info(here, "m.obj")["meshes"][0];
    INFO(c.what << "\n" << mesh.dump(1));
    CHECK(mesh[c.field] == c.count);
    bool said = false;
    for (const Json& finding : mesh["findings"]) {
      said |= contains(finding.get<std::string>(), c.phrase);
    }
    CHECK(said);
    CHECK(contains(here.run("info m.obj").out, c.phrase));
  }
}

TEST_CASE("an outline that only touches itself is not said to cross itself") {
  const WorkingDirectory here;
  here.write("m.obj",
             "v -2 -2 0\nv 0 -2 0\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv -2 0 0\n"
             "f 1 2 3 4 5 6 3 7\n");
  const Json mesh = info(here, "m.obj")["meshes"][0];
  CHECK(mesh["self_intersecting_faces"] == 0);
  CHECK(mesh["triangles"] == 4);
  CHECK(mesh["area"] == 8);
}

TEST_CASE("vertices that nothing uses are left out, with a warning") {
  const WorkingDirectory here;
  here.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 7 7 7\nf 1 2 3\n");
  const Json json = info(here, "m.obj");
  CHECK(json["bounds"]["high"] == Json({1, 1, 0}));
  REQUIRE(json["warnings"].size() == 1);
  CHECK(contains(json["warnings"][0].get<std::string>(), "1 of 4 vertices"));
  CHECK(contains(here.run("info m.obj").out, "warning: 1 of 4 vertices"));
}

TEST_CASE("vertices of a glTF file that nothing uses are counted or warned of") {
  const WorkingDirectory here;
  here.write("m.bin", float_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0, 7, 7, 7}) +
                          std::string("\x00\x00\x01\x00\x02\x00", 6));
  here.write("m.gltf", R"({
    "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "scene": 0, "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                   "min": [0, 0, 0], "max": [7, 7, 7]},
                  {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 6}],
    "buffers": [{"uri": "m.bin", "byteLength": 54}]})");
  const Json json = info(here, "m.gltf");
  CHECK((json["meshes"][0]["unused_vertices"] == 1 || json["warnings"].size() == 1));
}

TEST_CASE("--json FILE writes the same that --json - prints") {
  const WorkingDirectory here;
  const Outcome printed = here.run("info room --json -");
  const Outcome written = here.run("info room --json room.json");
  REQUIRE(written.exit_code == 0);
  CHECK(here.read("room.json") == printed.out);
  CHECK(contains(written.out, "room (built-in)"));
}

TEST_CASE("--write gives a GLB of the same scene, for every built-in one") {
  for (const char* name : {"teapot:3", "cube", "sphere:8", "forest", "room", "checker", "thicket",
                           "f-glyph", "depth-ladder"}) {
    const WorkingDirectory here;
    const Json before = info(here, std::string(name) + " --write s.glb");
    const Json after = info(here, "s.glb");
    INFO(name);
    for (const char* field : {"instances", "triangles", "lines", "points", "bounds", "lights"}) {
      INFO(field);
      CHECK(before[field] == after[field]);
    }
    CHECK(before["cameras"].size() == after["cameras"].size());
    CHECK(before["images"] == after["images"]);
    CHECK(after["warnings"].empty());
  }
}

TEST_CASE("lines and points are counted as drawn") {
  const WorkingDirectory here;
  here.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\np 1 2 3\n");
  const Json json = info(here, "m.obj");
  CHECK(json["lines"] == 2);
  CHECK(json["points"] == 3);
  CHECK(json["triangles"] == 0);
}

}  // namespace
}  // namespace glassbox::test
