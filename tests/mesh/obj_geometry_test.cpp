#include <cmath>
#include <string>

#include <glassbox/images/srgb.h>
#include <glassbox/mesh/obj/load.h>

#include "tests/support/catch.h"
#include "tests/support/contains.h"

namespace glassbox {
namespace {

using test::contains;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Scene load(const std::string& obj) {
  auto scene = load_obj_memory(obj, "");
  INFO(obj.substr(0, 400));
  INFO((scene ? std::string() : scene.error().message()));
  REQUIRE(scene);
  return std::move(*scene);
}

// The message of the error; it must be one line.
std::string refusal(const std::string& obj, const LoadLimits& limits = {}) {
  const auto scene = load_obj_memory(obj, "", limits);
  INFO(obj.substr(0, 400));
  REQUIRE_FALSE(scene);
  CHECK_FALSE(scene.error().cause.empty());
  CHECK_FALSE(scene.error().remedy.empty());
  CHECK(scene.error().message().find('\n') == std::string::npos);
  return scene.error().message();
}

bool warns_of(const Scene& scene, const std::string& part) {
  for (const std::string& warning : scene.warnings) {
    if (contains(warning, part)) return true;
  }
  return false;
}

// The positions of a face's corners, in order.
std::vector<Point<Object>> outline(const Mesh& mesh, std::size_t face) {
  std::vector<Point<Object>> points;
  for (std::uint32_t i = 0; i < mesh.faces[face].count; ++i) {
    points.push_back(mesh.positions[mesh.corners[mesh.faces[face].first + i].position]);
  }
  return points;
}

const std::vector<Point<Object>> kTriangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

}  // namespace

TEST_CASE("OBJ: a face keeps its separate indices for position, texture and normal (S3-01)") {
  const Scene scene = load(kSquare +
                           "vt 0 0\nvt 1 0\nvn 0 0 1\n"
                           "f 1/2/1 2/1/1 3/2/1\nf 1//1 3//1 4//1\nf 1/1 2/2 4/1\nf 1 2 3\n");
  REQUIRE(scene.meshes.size() == 1);
  const Mesh& mesh = scene.meshes[0];
  REQUIRE(mesh.faces.size() == 4);
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.texcoords.size() == 2);
  CHECK(mesh.normals.size() == 1);
  CHECK(mesh.corners[0] == Corner{0, 0, 0, kNone});
  CHECK(mesh.corners[1] == Corner{1, 0, 1, kNone});
  CHECK(mesh.corners[3] == Corner{0, 0, kNone, kNone});
  CHECK(mesh.corners[6] == Corner{0, kNone, 1, kNone});
  CHECK(mesh.corners[9] == Corner{0, kNone, kNone, kNone});
  CHECK(scene.warnings.empty());
}

TEST_CASE("OBJ: a face of a thousand corners stays one face of a thousand corners") {
  std::string text;
  std::string face = "f";
  for (int i = 0; i < 1000; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  const Scene scene = load(text + face + "\n");
  REQUIRE(scene.meshes[0].faces.size() == 1);
  REQUIRE(scene.meshes[0].faces[0].count == 1000);
  CHECK(outline(scene.meshes[0], 0)[999] == Point<Object>(999, 998001, 0));
}

TEST_CASE("OBJ: negative indices count back from the line they stand in") {
  const Scene scene = load("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 7 7 7\nf -4 -3 -2\n");
  CHECK(outline(scene.meshes[0], 0) == kTriangle);
  CHECK(outline(scene.meshes[0], 1) == kTriangle);
}

TEST_CASE("OBJ: faces may stand before the vertices they name") {
  const Scene scene = load("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
  CHECK(outline(scene.meshes[0], 0) == kTriangle);
}

TEST_CASE("OBJ: spacing, line ends, comments and continued lines do not matter") {
  const std::string text = GENERATE(
      as<std::string>{}, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
      "\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
      "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
      "v\t0\t0\t0\t\n  v  1   0  0   \n\n\n v 0 1 0\n\tf\t1  2\t3 \t\n",
      "v 0 0 0 # one\nv 1 0 0 #two\nv 0 1 0\n  # f 3 2 1\n#f 3 2 1\nf 1 2 3 # 4 5\n",
      "v 0 0 0\nv 1 0 0\nv 0 \\\n 1 0\nf 1 \\\r\n2 \\\n3\n",
      "v 0 0 0\nv 1 0 0\n# in C:\\models\\\nv 0 1 0\nf 1 2 3\n",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\\");
  CHECK(outline(load(text).meshes[0], 0) == kTriangle);
}

TEST_CASE("OBJ: every decimal notation gives the nearest float") {
  // The last two numbers: one halfway between 1 and its successor, which is rounded to even, and
  // one a digit above it, which is rounded up.
  const Scene scene = load(
      "v .5 5. +1.5\nv -.5 1e2 1E-2\nv +1.5e+1 1e-60 -1e-60\nv 0.1 1e-45 3.4028235e38\n"
      "v 1.000000059604644775390625 1.0000000596046447753906251 000000000000000000000000001\nf 1 2 "
      "3 4 5\n");
  const auto points = outline(scene.meshes[0], 0);
  CHECK(points[0] == Point<Object>(0.5f, 5.0f, 1.5f));
  CHECK(points[1] == Point<Object>(-0.5f, 100.0f, 0.01f));
  CHECK(points[2] == Point<Object>(15.0f, 0.0f, 0.0f));
  CHECK(std::signbit(points[2].z));
  CHECK(points[3] == Point<Object>(0.1f, 0x1p-149f, 0x1.fffffep127f));
  CHECK(points[4] == Point<Object>(1.0f, 0x1.000002p0f, 1.0f));
}

TEST_CASE("OBJ: numbers too small for a float are zero, however they are written") {
  const std::string zeros(400, '0');
  const Scene scene =
      load("v 0." + zeros + "1 1e-99999999999999999999 0e99999999999999999999\nv 1" + zeros +
           "e-400 0." + zeros + "1e401 0\nv 0 1 0\nf 1 2 3\n");
  const auto points = outline(scene.meshes[0], 0);
  CHECK(points[0] == Point<Object>(0, 0, 0));
  CHECK(points[1] == Point<Object>(1, 1, 0));
}

TEST_CASE("OBJ: normals are made unit length, and those without direction are none") {
  const Scene scene = load(
      kSquare + "vn 0 0 1e30\nvn 3e38 -3e38 0\nvn 1e-45 0 0\nvn 0 0 0\nf 1//1 2//2 3//3 4//4\n");
  const Mesh& mesh = scene.meshes[0];
  REQUIRE(mesh.normals.size() == 3);
  CHECK(mesh.normals[0] == Normal<Object>(0, 0, 1));
  CHECK(mesh.normals[1] == Normal<Object>(float(std::sqrt(0.5)), -float(std::sqrt(0.5)), 0));
  CHECK(mesh.normals[2] == Normal<Object>(1, 0, 0));
  CHECK(mesh.corners[3].normal == kNone);
  CHECK(warns_of(scene, "1 normal is zero"));
}

TEST_CASE("OBJ: texture coordinates are turned top down, and unreadable ones are none") {
  const Scene scene = load(kSquare + "vt 0.25 0.75 9\nvt 0.5\nvt nan 0\nf 1/1 2/2 3/3\n");
  const Mesh& mesh = scene.meshes[0];
  REQUIRE(mesh.texcoords.size() == 2);
  CHECK(mesh.texcoords[0] == TexCoord{0.25f, 0.25f});
  CHECK(mesh.texcoords[1] == TexCoord{0.5f, 1.0f});
  CHECK(mesh.corners[2].texcoord == kNone);
  CHECK(warns_of(scene, "1 pair of texture coordinates is not finite"));
}

TEST_CASE("OBJ: vertex colours are sRGB; vertices without one have none") {
  const Scene scene = load("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
  const Mesh& mesh = scene.meshes[0];
  REQUIRE(mesh.colors.size() == 2);
  CHECK(mesh.colors[mesh.corners[0].color] == Rgba{1, decode_srgb(128), 0, 1});
  CHECK(mesh.corners[1].color == kNone);
  CHECK(mesh.colors[mesh.corners[2].color] == Rgba{0, 0, 1, 1});
}

TEST_CASE("OBJ: weights do not move vertices, and weights other than 1 are mentioned") {
  CHECK(load("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").warnings.empty());
  const Scene scene = load("v 0 0 0 1\nv 1 0 0 2\nv 0 1 0 0\nf 1 2 3\n");
  CHECK(outline(scene.meshes[0], 0) == kTriangle);
  CHECK(warns_of(scene, "2 vertex weights other than 1"));
}

TEST_CASE("OBJ: polylines become segments, points become points") {
  const Scene scene = load(kSquare + "vt 0 0\nl 1/1 2/1 3\np 2 4\nl 1 -1\n");
  REQUIRE(scene.meshes.size() == 1);
  const Mesh& mesh = scene.meshes[0];
  REQUIRE(mesh.lines.size() == 3);
  CHECK(mesh.positions[mesh.lines[1][0].position] == Point<Object>(1, 0, 0));
  CHECK(mesh.positions[mesh.lines[1][1].position] == Point<Object>(1, 1, 0));
  CHECK(mesh.lines[0][0].texcoord == 0);
  CHECK(mesh.lines[1][1].texcoord == kNone);
  REQUIRE(mesh.points.size() == 2);
  CHECK(mesh.positions[mesh.points[1].position] == Point<Object>(0, 1, 0));
}

TEST_CASE("OBJ: indices into a table that the whole file lacks are left out with a warning") {
  const Scene scene = load(kSquare + "f 1/1/7 2/2/8 3/3/9\nl 1/1 4/9\n");
  CHECK(scene.meshes[0].corners[2] == Corner{2, kNone, kNone, kNone});
  CHECK(scene.meshes[0].lines[0][0] == Corner{0, kNone, kNone, kNone});
  CHECK(warns_of(scene, "corners name texture coordinates, but the file has none"));
  CHECK(warns_of(scene, "corners name normals, but the file has none"));
  CHECK(contains(refusal(kSquare + "vn 0 0 1\nf 1//1 2//1 3//2\n"), "line 6: names normal 2"));
  CHECK(contains(refusal(kSquare + "vt 0 0\nl 1/1 2/2\n"), "line 6: names texture coordinate 2"));
}

TEST_CASE("OBJ: one mesh for each object, group and material, with only what it uses") {
  const Scene scene =
      load(kSquare +
           "o house # comment\nusemtl a\nf 1 2 3\ng roof top\nf 2 3 4\nusemtl b\n"
           "f 3 4 1\no shed\nusemtl a\nf 1 2 4\no house\ng roof top\nf 4 3 2\ng\nl 1 2\n");
  REQUIRE(scene.meshes.size() == 4);
  CHECK(scene.meshes[0].name == "house");
  CHECK(scene.meshes[1].name == "house/roof top");
  CHECK(scene.meshes[2].name == "house/roof top");
  CHECK(scene.meshes[3].name == "shed/roof top");
  CHECK(scene.meshes[0].lines.size() == 1);
  CHECK(scene.meshes[1].faces.size() == 2);
  CHECK(scene.meshes[2].faces.size() == 1);
  CHECK(scene.meshes[1].material == scene.meshes[0].material);
  CHECK(scene.meshes[2].material != scene.meshes[0].material);
  CHECK(scene.meshes[0].positions.size() == 3);
  CHECK(outline(scene.meshes[1], 1) == std::vector<Point<Object>>{{0, 1, 0}, {1, 1, 0}, {1, 0, 0}});

  REQUIRE(scene.nodes.size() == 1);
  CHECK(scene.nodes[0].world_from_node == Transform<World, Object>());
  REQUIRE(scene.instances.size() == 4);
  for (std::uint32_t i = 0; i < 4; ++i) {
    CHECK(scene.instances[i].mesh == i);
    CHECK(scene.instances[i].node == 0);
  }
}

TEST_CASE("OBJ: what can be done without is left out with a warning") {
  CHECK(
      warns_of(load(kSquare + "f 1 2 3\nf 1\nf 2 3\nf\n"), "3 faces of fewer than three corners"));
  CHECK(warns_of(load(kSquare + "f 1 2 3\nl 1\np\n"), "2 lines or points"));
  CHECK(warns_of(load(kSquare + "cstype bezier\nend\nf 1 2 3\n"), "2 statements of free-form"));
  CHECK(warns_of(load(kSquare + "xyzzy 1\nf 1 2 3\n"), "'xyzzy'"));
  CHECK(warns_of(load(kSquare + "f 1 2 3\n"), "1 of 4 vertices is not used and was left out"));
  CHECK(warns_of(load(kSquare + "v 3.1+e2 0 0\nv 1\nv 0 nan 0\nv 0 0 -inf\nf 1 2 3 4\n"),
                 "4 unused vertices do not have three finite numbers (first in line 5)"));
  CHECK(load(kSquare + "s 1\ns off\nf 1 2 3 4\n").warnings.empty());
}

TEST_CASE("OBJ: a coordinate that is no finite number is an error with line and vertex") {
  for (const std::string bad :
       {"nan", "-nan", "inf", "-inf", "infinity", "1e999", "-1e39", "nan(ind)"}) {
    const std::string message = refusal("v 0 0 0\n\nv 0 " + bad + " 0\nf 1 2 2\n");
    CHECK(contains(message, "line 3: vertex 2"));
    CHECK(contains(message, bad));
  }
  for (const std::string bad : {"0x10", "1.#QNAN", "x", "1,5", "--1", "+-1", "3.1+e2", "1e"}) {
    CHECK(contains(refusal("v 0 0 0\n\nv 0 " + bad + " 0\nf 1 2 2\n"), "line 3: vertex 2"));
  }
  CHECK(contains(refusal("v 0 0 0\n\nv 0 0\nf 1 2 2\n"), "line 3: vertex 2"));
}

TEST_CASE("OBJ: an index that names nothing is an error with its line") {
  for (const std::string bad : {"0",
                                "5",
                                "-5",
                                "4294967297",
                                "4294967295",
                                "18446744073709551617",
                                "-9223372036854775808",
                                "9223372036854775807",
                                "a",
                                "1.5",
                                "/1",
                                "//1",
                                "1/2",
                                "1/0",
                                "1/x",
                                "1//2",
                                "1//0",
                                "1/1/1/1",
                                "1/-2",
                                "0x1"}) {
    CAPTURE(bad);
    CHECK(
        contains(refusal(kSquare + "vt 0 0\nvn 0 0 1\nf 1 2 " + bad + "\nf 1 2 3\n"), "line 7: "));
  }
  // The number of a continued line is that of its first line.
  CHECK(contains(refusal(kSquare + "f 1 2 \\\n\\\n 9\n"), "line 5: names vertex 9"));
  CHECK(contains(refusal("vt 0 0\nf 1/1 1/1 1/1\n"), "line 2: names vertex 1"));
}

TEST_CASE("OBJ: a file with nothing to draw is an error") {
  CHECK(contains(refusal(""), "no faces"));
  CHECK(contains(refusal(kSquare), "no faces"));
  CHECK(contains(refusal("# nothing\n\n"), "no faces"));
  CHECK(contains(refusal(kSquare + "f 1\n"), "no faces"));
  CHECK(contains(refusal(std::string(1000, '\0')), "no faces"));
}

TEST_CASE("OBJ: limits hold") {
  LoadLimits limits;
  limits.max_corners = 8;
  CHECK(load_obj_memory(kSquare + "f 1 2 3 4\nf 1 2 3 4\n", "", limits));
  CHECK(contains(refusal(kSquare + "f 1 2 3 4\nf 1 2 3 4\np 1\n", limits), "line 7: "));
  // A polyline of n vertices has 2 (n - 1) corners.
  CHECK(load_obj_memory(kSquare + "l 1 2 3 4 1\n", "", limits));
  CHECK(contains(refusal(kSquare + "l 1 2 3 4 1 2\n", limits), "line 5: "));
  limits.max_file_bytes = 20;
  CHECK(contains(refusal(kSquare + "f 1 2 3 4\n", limits), "20 bytes"));
}

TEST_CASE("OBJ: long lines, long names and a million odd lines take linear time and few warnings") {
  // A loader with quadratic running time would take hours here.
  std::string text = kSquare + "# " + std::string(10'000'000, 'x') + "\n";
  text += "o " + std::string(1'000'000, 'n') + "\n";
  for (int i = 0; i < 50'000; ++i) text += "g " + std::to_string(i) + "\nf 1 2 3\n";
  for (int i = 0; i < 200'000; ++i) {
    const std::string n = std::to_string(i);
    text += "mtllib " + n + ".mtl\nusemtl " + n + "\nf 1\nzz" + n + "\nvn 0 0 0\n";
  }
  text += "f 1 2 3";
  for (int i = 0; i < 1'000'000; ++i) text += " \\\n4";
  const Scene scene = load(text);
  CHECK(scene.meshes.size() == 50'001);
  CHECK(scene.meshes.back().faces[0].count == 1'000'003);
  CHECK(scene.meshes[0].name.size() < 1000);
  CHECK(scene.warnings.size() < 100);
}

}  // namespace glassbox
