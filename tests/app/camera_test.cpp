// Tests which camera a picture is taken with, and that wrong cameras are refused.
#include "tests/support/catch.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/text.h"

namespace glassbox::test {
namespace {

// A file with two scenes, and two cameras over one triangle. The scene that is not the default one
// would cover the picture with another triangle.
constexpr const char* kTwoScenes = R"({
  "asset": {"version": "2.0"},
  "scene": 1,
  "scenes": [{"nodes": [2]}, {"nodes": [0, 1, 3]}],
  "nodes": [
    {"name": "front", "camera": 0, "translation": [0, 0, 4]},
    {"name": "above", "camera": 1, "rotation": [-0.7071067811865476, 0, 0, 0.7071067811865476],
     "translation": [0, 4, 0]},
    {"name": "not in the default scene", "mesh": 0, "scale": [9, 9, 9], "translation": [0, 0, 1]},
    {"name": "shown", "mesh": 0}
  ],
  "cameras": [
    {"name": "front", "type": "perspective", "perspective": {"yfov": 1, "znear": 0.5, "zfar": 20}},
    {"name": "above", "type": "orthographic",
     "orthographic": {"xmag": 2, "ymag": 2, "znear": 0.5, "zfar": 20}}
  ],
  "materials": [{"doubleSided": true}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                 "min": [-1, 0, -1], "max": [1, 1, 1]}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}]
})";

void write_two_scenes(const WorkingDirectory& here) {
  here.write("triangle.bin", float_bytes({-1, 0, 1, 1, 0, 1, 0, 1, -1}));
  here.write("two.gltf", kTwoScenes);
}

std::string picture_by_camera(const WorkingDirectory& here, const std::string& options) {
  const Outcome outcome = here.run("render two.gltf --size 32x32 -o p.ppm " + options);
  INFO(options << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return here.read("p.ppm");
}

TEST_CASE("a camera is chosen by name or index; the first one is the default") {
  const WorkingDirectory here;
  write_two_scenes(here);
  const std::string front = picture_by_camera(here, "");
  const std::string above = picture_by_camera(here, "--camera above");
  CHECK(picture_by_camera(here, "--camera front") == front);
  CHECK(picture_by_camera(here, "--camera 0") == front);
  CHECK(picture_by_camera(here, "--camera 1") == above);
  CHECK(front != above);
  // The same lens and place, given on the command line: 1 radian is 57.29... degrees.
  CHECK(picture_by_camera(
            here, "--eye 0,0,4 --look-at 0,0,0 --fov 57.29577951308232 --near 0.5 --far 20") ==
        front);
  CHECK(picture_by_camera(
            here, "--eye 0,4,0 --look-at 0,0,0 --up 0,0,-1 --ortho 4 --near 0.5 --far 20") ==
        above);
}

TEST_CASE("a camera that cannot be used is an error only where it is chosen") {
  const WorkingDirectory here;
  write_two_scenes(here);
  const std::string above = picture_by_camera(here, "--camera above");
  const std::string automatic = picture_by_camera(here, "--camera none");
  std::string text = kTwoScenes;
  const std::string good = "\"yfov\": 1,";
  text.replace(text.find(good), good.size(), "\"yfov\": 4,");
  here.write("two.gltf", text);
  CHECK(picture_by_camera(here, "--camera none") == automatic);
  CHECK(picture_by_camera(here, "--camera 1") == above);
  CHECK(picture_by_camera(here, "") == above);  // the first that can be used
  for (const char* chosen : {"--camera front", "--camera 0"}) {
    const Outcome refused = here.run(std::string("render two.gltf --size 8x8 ") + chosen);
    CHECK(refused.exit_code == 2);
    CHECK(contains(refused.err, std::string(chosen) + ": this camera cannot be used: camera 0"));
  }
  const Outcome info = here.run("info two.gltf");
  CHECK(contains(info.out, "camera 0 'front': cannot be used"));
  CHECK(contains(info.out, "the camera 'front' cannot be used: camera 0: its field of view"));
}

TEST_CASE("only the default scene of a file is drawn") {
  const WorkingDirectory here;
  write_two_scenes(here);
  const Outcome outcome = here.run("render two.gltf --size 8x8 --json -");
  CHECK(contains(outcome.out, "\"triangles\": 1,"));
}

TEST_CASE("a lens on the command line replaces the camera's, its pose stays") {
  const WorkingDirectory here;
  write_two_scenes(here);
  const std::string wide = picture_by_camera(here, "--camera front --fov 90");
  CHECK(wide != picture_by_camera(here, "--camera front"));
  CHECK(wide ==
        picture_by_camera(here, "--eye 0,0,4 --look-at 0,0,0 --fov 90 --near 0.5 --far 20"));
}

TEST_CASE("without a camera the whole scene is in the picture, whatever its size and place") {
  for (const char* scale : {"1", "1e-6", "1e6"}) {
    for (const char* offset : {"0", "3"}) {
      const WorkingDirectory here;
      // A diamond without flat sides along the view. The exponents of its coordinates in the OBJ
      // text give the scale.
      const std::string s(scale), o(offset);
      const std::string e = s == "1" ? std::string() : s.substr(1);
      const auto v = [&](int x, int y, int z) {
        const int shift = std::stoi(o);
        return "v " + std::to_string(x + shift) + e + " " + std::to_string(y + shift) + e + " " +
               std::to_string(z + shift) + e + "\n";
      };
      here.write("diamond.obj", v(1, 0, 0) + v(0, 1, 0) + v(0, 0, 1) + v(-1, 0, 0) + v(0, -1, 0) +
                                    v(0, 0, -1) +
                                    "f 1 2 3\nf 2 4 3\nf 4 5 3\nf 5 1 3\n"
                                    "f 2 1 6\nf 4 2 6\nf 5 4 6\nf 1 5 6\n");
      const Outcome outcome = here.run("render diamond.obj --size 64x48 --id-out p.pfm");
      INFO("scale " << scale << ", offset " << offset << ": " << outcome.err);
      REQUIRE(outcome.exit_code == 0);
      const Plane plane = parse_pfm(here.read("p.pfm"));
      const auto covered =
          std::count_if(plane.values.begin(), plane.values.end(), [](float id) { return id != 0; });
      CHECK(covered > 64 * 48 / 10);
      for (int x = 0; x < 64; ++x) CHECK((plane.at(x, 0) == 0 && plane.at(x, 47) == 0));
      for (int y = 0; y < 48; ++y) CHECK((plane.at(0, y) == 0 && plane.at(63, y) == 0));
    }
  }
}

TEST_CASE("with --up alone the whole scene is in the picture, upright, from its own distance") {
  const WorkingDirectory here;
  // A tower 12 units high along z, the up axis of many scans.
  here.write("tower.obj",
             "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 12\nv 1 -1 12\nv 1 1 12\nv -1 1 12\n"
             "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  for (const char* up : {"0,0,1", "0,0,-1", "0,-1,0", "1,0,0", "1,2,-3", "0,1,0"}) {
    const Outcome outcome =
        here.run(std::string("render tower.obj --size 64x48 --id-out p.pfm --up ") + up);
    INFO(up << ": " << outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const Plane plane = parse_pfm(here.read("p.pfm"));
    int outermost = 64;  // distance of the outermost drawn pixel from the border
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        if (plane.at(x, y) != 0) outermost = std::min({outermost, x, y, 63 - x, 47 - y});
      }
    }
    // The margin is at least a twentieth of the picture on two sides, and nothing is cut off.
    CHECK(outermost >= 1);
    CHECK(outermost <= 4);
  }
}

TEST_CASE("--up 0,1,0, of any length, is what goes without saying, byte for byte") {
  const WorkingDirectory here;
  for (const char* scene : {"teapot", "cube --fov 20", "teapot --ortho 9"}) {
    const std::string words = std::string("render ") + scene + " --size 64x48 -o ";
    REQUIRE(here.run(words + "a.ppm").exit_code == 0);
    REQUIRE(here.run(words + "b.ppm --up 0,2.5,0").exit_code == 0);
    const auto pixels = [&](const char* name) {
      const std::string bytes = here.read(name);
      return bytes.substr(bytes.size() - 64 * 48 * 3);
    };
    INFO(scene);
    CHECK(pixels("a.ppm") == pixels("b.ppm"));
  }
}

TEST_CASE("--far inf and no far plane at all are the same; what lies far is drawn") {
  const WorkingDirectory here;
  here.write("far.obj", "v -1e9 -1e9 -1e9\nv 1e9 -1e9 -1e9\nv 0 1e9 -1e9\nf 1 2 3\n");
  const Outcome outcome = here.run(
      "render far.obj --size 8x8 --eye 0,0,0 --look-at 0,0,-1 --near 0.1 --far inf --depth-out "
      "d.pfm");
  REQUIRE(outcome.exit_code == 0);
  CHECK(parse_pfm(here.read("d.pfm")).at(4, 4) == 1e9f);
}

TEST_CASE("degenerate cameras are rejected with the reason and the remedy") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"--eye 0,5,0 --look-at 0,0,0", {"up", "roll is undefined", "choose another"}},
      {"--eye 1,1,1 --look-at 0,0,0 --up 2,2,2", {"up", "choose another"}},
      {"--eye 1,2,3 --look-at 1,2,3", {"look-at", "is the eye itself", "move one"}},
      {"--up 0,0,0", {"up", "not a direction", "such as"}},
      {"--fov 0", {"--fov", "0 degrees", "between 0 and 180"}},
      {"--fov 180", {"--fov", "180 degrees", "between 0 and 180"}},
      {"--fov -45", {"--fov", "-45 degrees", "between 0 and 180"}},
      {"--fov 360", {"--fov", "between 0 and 180"}},
      {"--fov nan", {"--fov", "nan", "between 0 and 180"}},
      {"--fov inf", {"--fov", "inf", "between 0 and 180"}},
      {"--fov 1e-300 --eye 0,0,5", {"projection", "field of view"}},
      {"--near 0", {"near plane", "0", "in front of the eye"}},
      {"--near -1", {"near plane", "-1", "in front of the eye"}},
      {"--near inf", {"near plane", "inf"}},
      {"--near 1e300", {"near plane", "1e+300", "scale"}},
      {"--near 2 --far 2", {"far plane", "same distance", "move the far plane away"}},
      {"--near 3 --far 2", {"far plane", "less than", "exchange"}},
      {"--far 0", {"far plane", "positive"}},
      {"--far -inf", {"far plane"}},
      {"--eye 1e300,0,0", {"near plane", "scale"}},
      {"--ortho 0", {"orthographic height", "positive"}},
      {"--ortho -2", {"orthographic height", "positive"}},
      {"--ortho nan", {"orthographic height", "positive"}},
      {"--ortho 1e300", {"float", "more ordinary size"}},
      {"--ortho 4 --far 2 --near 3", {"far plane", "near < far"}},
      {"--ortho 4 --far inf", {"far plane", "parallel", "finite"}},
      {"--ortho 4 --near 5 --far 5", {"far plane", "near < far"}},
      {"--frustum 1,-1,-1,1", {"window", "left < right"}},
      {"--frustum -1,1,1,1", {"window", "bottom < top"}},
      {"--fov 40 --ortho 2", {"--ortho", "give one"}},
      {"--ortho 2 --frustum -1,1,-1,1", {"--frustum", "give one"}},
      {"--camera 0 --eye 1,2,3", {"--camera", "give one"}}};
  for (const auto& [options, parts] : cases) {
    const WorkingDirectory here;
    const Outcome outcome = here.run("render cube --size 8x8 " + options);
    INFO(options << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.out.empty());
    CHECK(here.names().empty());
    for (const std::string& part : parts) {
      INFO("expected: " << part);
      CHECK(contains(outcome.err, part));
    }
  }
}

TEST_CASE("a camera that is not there is refused with the names of those that are") {
  const WorkingDirectory here;
  write_two_scenes(here);
  for (const char* name : {"2", "-1", "behind", "Front"}) {
    const Outcome outcome = here.run(std::string("render two.gltf --camera ") + name);
    INFO(name << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "0 'front', 1 'above'"));
  }
}

TEST_CASE("a plane asked for moves the one that was found out of its way") {
  const WorkingDirectory here;
  here.write("wall.obj", "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n");
  const std::string start = "render wall.obj --size 4x4 --eye 0,0,5 --look-at 0,0,0 ";
  for (const char* planes : {"--near 9", "--far 1", "--ortho 4 --near 9", "--ortho 4 --far 1",
                             "--ortho 4 --far -1", "--ortho 4 --near -9"}) {
    const Outcome outcome = here.run(start + planes);
    INFO(planes << ": " << outcome.err);
    CHECK(outcome.exit_code == 0);
  }
}

TEST_CASE("a scene without cameras says so when one is asked for") {
  const WorkingDirectory here;
  here.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome outcome = here.run("render a.obj --camera 0");
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "no cameras"));
}

}  // namespace
}  // namespace glassbox::test
