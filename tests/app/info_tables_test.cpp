// Tests glassbox info --tables: the tables of a mesh as one writes them by hand (S4-15 to S4-17).
#include "tests/support/catch.h"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/app/text.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Json tables_of(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("info " + words + " --tables --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out)["meshes"][0]["tables"];
}

// The strip of the slide: F1 = (V1, V2, V3), F2 = (V3, V2, V4), F3 = (V3, V4, V5).
const std::string kStrip =
    "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nf 1 2 3\nf 3 2 4\nf 3 4 5\n";

TEST_CASE("the strip's tables have its vertices, edges and faces with their neighbours (S4-17)") {
  const WorkingDirectory here;
  here.write("m.obj", kStrip);
  const Json json = tables_of(here, "m.obj");
  REQUIRE(json["vertices"].size() == 5);
  CHECK(json["vertices"][2]["position"] == Json({1, 0, 0}));
  CHECK(json["vertices"][2]["faces"] == Json({0, 1, 2}));
  CHECK(json["vertices"][4]["faces"] == Json({2}));
  REQUIRE(json["edges"].size() == 7);
  int boundary = 0;
  for (const Json& edge : json["edges"]) {
    boundary += edge["boundary"].get<bool>();
    const std::size_t faces = edge["passed_by"].size() + edge["passed_back_by"].size();
    CHECK(edge["named"] == (faces == 1 ? "boundary" : ""));
  }
  CHECK(boundary == 5);
  REQUIRE(json["faces"].size() == 3);
  CHECK(json["faces"][1]["vertices"] == Json({2, 1, 3}));
  CHECK(json["faces"][1]["faces_beside"] == Json({0, 2}));
  CHECK(json["faces"][0]["faces_beside"] == Json({1}));
  for (const char* name : {"vertices_left_out", "edges_left_out", "faces_left_out"})
    CHECK(json[name] == 0);

  const std::string text = unwrapped(here.run("info m.obj --tables").out);
  CHECK(contains(text, "5 vertices (5 positions; those in one place are one vertex)"));
  CHECK(contains(text, "v2 1 0 0 f0 f1 f2"));
  CHECK(contains(text, "7 edges: 5 boundary, 0 non-manifold, 0 where the winding changes"));
  CHECK(contains(text, "e0 v0 v1 f0 boundary"));
  CHECK(contains(text, "f1 v2 v1 v3"));
}

TEST_CASE("edges of more than two faces, and of faces that turn differently, are named") {
  const WorkingDirectory here;
  here.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
  const Json three = tables_of(here, "m.obj")["edges"][0];
  CHECK(three["vertices"] == Json({0, 1}));
  CHECK(three["passed_by"] == Json({0, 2}));
  CHECK(three["passed_back_by"] == Json({1}));
  CHECK(three["non_manifold"] == true);
  CHECK(three["named"] == "non-manifold: 3 faces");
  here.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n");
  CHECK(contains(here.run("info m.obj --tables").out, "the winding changes"));
}

TEST_CASE("Newell's sums are printed edge by edge, as one adds them by hand (S4-16)") {
  const WorkingDirectory here;
  here.write("m.obj", "v 1 2 5\nv 3 2 5\nv 3 4 5\nv 1 4 5\nf 1 2 3 4\n");
  const Json face = tables_of(here, "m.obj")["faces"][0];
  // (x_i - x_j)(y_i + y_j): -2 * 4, 0, 2 * 8, 0.
  const std::vector<double> terms{-8, 0, 16, 0}, sums{-8, -8, 8, 8};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(face["newell_rows"][i]["terms"][2] == terms[i]);
    CHECK(face["newell_rows"][i]["sums"][2] == sums[i]);
  }
  CHECK(face["newell"] == Json({0, 0, 8}));
  CHECK(face["product"] == Json({0, 0, 4}));
  CHECK(face["unit"] == Json({0, 0, 1}));
  CHECK(face["named"] == "");
  const std::string text = unwrapped(here.run("info m.obj --tables").out);
  CHECK(contains(text, "Nx = sum (y_i - y_j)(z_i + z_j)"));
  CHECK(contains(text, "v2 v3 0 0 16 -20 0 8"));
  CHECK(contains(text, "f0 (0, 0, 4) (0, 0, 8) (0, 0, 1)"));
}

TEST_CASE("where the product of two edges is no normal, the table says why (C-21, C-23, C-24)") {
  struct Case {
    const char *obj, *named;
  };
  for (const Case& c : std::vector<Case>{
           {"v 0 0 0\nv 1 1 0\nv 2 0 0\nv 1 3 0\nf 1 2 3 4\n", "the second corner is reflex"},
           {"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3 4\n", "first three corners are on a line"},
           {"v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\n", "the face is bent"},
           {"v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", "the face has no area"},
           {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "no area, no normal"},
           {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ""}}) {
    const WorkingDirectory here;
    here.write("m.obj", c.obj);
    const std::string named = tables_of(here, "m.obj")["faces"][0]["named"];
    INFO(c.named << " in " << named);
    CHECK((*c.named == '\0' ? named.empty() : contains(named, c.named)));
  }
}

TEST_CASE("far from the origin the sums are within their bound of those from a corner (C-22)") {
  const WorkingDirectory here;
  here.write("m.obj",
             "v 1e6 1e6 1e6\nv 1000001 1e6 1e6\nv 1000001 1000001 1e6\nv 1e6 1000001 1e6\nf 1 2 3 "
             "4\n");
  const Json face = tables_of(here, "m.obj")["faces"][0];
  CHECK(face["newell_from_first_corner"] == Json({0, 0, 2}));
  const double bound = face["newell_error_bound"][2];
  CHECK(std::abs(face["newell"][2].get<double>() - 2) <= bound);
  CHECK(bound < 1e-8);
  CHECK(bound > 1e-10);  // on the scale of 1e6 times the unit roundoff
}

TEST_CASE("a large mesh has as many rows as asked for, and the rest is counted") {
  const WorkingDirectory here;
  const Json whole = Json::parse(here.run("info sphere:16 --json -").out)["meshes"][0];
  for (const std::string& rows : {std::string("0"), std::string("7"), std::string("1000000")}) {
    INFO(rows);
    const Json json = tables_of(here, "sphere:16 --rows " + rows);
    for (const char* name : {"vertices", "edges", "faces"}) {
      const std::uint64_t shown = json[name].size();
      CHECK(shown <= std::stoull(rows));
      const auto left_out = json[std::string(name) + "_left_out"].get<std::uint64_t>();
      CHECK(shown + left_out == whole[name].get<std::uint64_t>());
    }
  }
  const std::string text = here.run("info sphere:16 --tables --rows 7").out;
  CHECK(contains(text, fmt::format("... {} more (--rows)", whole["edges"].get<int>() - 7)));
  CHECK(contains(text, fmt::format("... {} faces more (--rows)", whole["faces"].get<int>() - 7)));
  CHECK(tables_of(here, "sphere:16")["faces"].size() == 20);
}

TEST_CASE("a vertex and an edge of very many faces have short rows") {
  const WorkingDirectory here;
  std::string obj = "v 0 0 0\nv 0 0 1\n";
  for (int i = 0; i < 3000; ++i)
    obj += fmt::format("v {} {} 0\nf 1 2 {}\n", 1 + i, i * i % 101, i + 3);
  here.write("m.obj", obj);
  const Outcome outcome = here.run("info m.obj --tables");
  REQUIRE(outcome.exit_code == 0);
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(line.size() <= 200);
  }
  CHECK(contains(outcome.out, "(+2992)"));
  CHECK(contains(outcome.out, "non-manifold: 3000 faces"));
  const Json json = tables_of(here, "m.obj");
  CHECK(json["vertices"][0]["faces"].size() == 1000);
  CHECK(json["vertices"][0]["faces_left_out"] == 2000);
}

TEST_CASE("vertices of a glTF file in one place are one vertex of the tables") {
  const WorkingDirectory here;
  const Json json = tables_of(here, "cube");
  CHECK(json["vertices"].size() == 8);
  for (const Json& vertex : json["vertices"]) CHECK(vertex["faces"].size() == 3);
  for (const Json& face : json["faces"]) CHECK(face["faces_beside"].size() == 4);
  REQUIRE(here.run("info cube --write c.glb").exit_code == 0);
  CHECK(tables_of(here, "c.glb")["vertices"].size() == 8);
}

TEST_CASE("a mesh without faces has tables without faces") {
  const WorkingDirectory here;
  here.write("m.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  const Json json = tables_of(here, "m.obj");
  CHECK(json["faces"].empty());
  CHECK(json["edges"].empty());
  CHECK(here.run("info m.obj --tables").exit_code == 0);
}

TEST_CASE("options of tables that make no sense are refused") {
  const WorkingDirectory here;
  check_refused(here.run("info cube --rows 3"), {"--rows", "--tables"});
  check_refused(here.run("info cube --tables --rows -1"), {"--rows"});
  check_refused(here.run("info cube --tables --rows x"), {"--rows"});
  REQUIRE(here.run("views layers build room --size 32x24 -o room.ldi").exit_code == 0);
  check_refused(here.run("info room.ldi --tables"), {"room.ldi", "has no meshes"});
}

}  // namespace
}  // namespace glassbox::test
