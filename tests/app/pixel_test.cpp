// Compares glassbox pixel with the planes that glassbox render writes.
#include "tests/support/catch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/scenes.h"
#include "tests/app/text.h"

#include <glassbox/images/read.h>

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

constexpr int kWidth = 40, kHeight = 30;  // px

struct Rendered {
  Image<Rgba8> color;
  Plane distance, ids;
  Json camera;
};

Rendered rendered(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run(
      "render " + words + " --size 40x30 -o p.png --depth-out d.pfm --id-out i.pfm --json -");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto image = read_image(here.file("p.png"));
  REQUIRE(image);
  return {*image, parse_pfm(here.read("d.pfm")), parse_pfm(here.read("i.pfm")),
          Json::parse(outcome.out)["camera"]};
}

Json pixel(const WorkingDirectory& here, const std::string& words, int x, int y) {
  const Outcome outcome = here.run("pixel " + words + " --size 40x30 --at " + std::to_string(x) +
                                   "," + std::to_string(y) + " --json -");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  return Json::parse(outcome.out);
}

struct Lens {
  bool perspective = true;
  double half_height = 0;  // at distance 1, or of the whole picture in parallel projection
};

using Point3 = std::array<double, 3>;

// Returns the point at this distance along the gaze through the pixel, in world space, computed
// from the description of the camera.
Point3 world_point(const Json& camera, const Lens& lens, int x, int y, double distance) {
  const double right = (2 * (x + 0.5) / kWidth - 1) * kWidth / kHeight,
               up = 1 - 2 * (y + 0.5) / kHeight;
  const double scale = lens.half_height * (lens.perspective ? distance : 1);
  const std::array<double, 4> eye{right * scale, up * scale, -distance, 1};
  Point3 world{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      world[row] += camera["world_from_eye_rows"][4 * row + column].get<double>() * eye[column];
    }
  }
  return world;
}

double length(const Point3& p) {
  return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

TEST_CASE("triangle, distance, colour and place in the world are those of the picture") {
  const double degrees = std::numbers::pi / 180;
  const std::vector<std::pair<std::string, Lens>> cases{
      {"teapot --fov 45", {true, std::tan(22.5 * degrees)}},
      {"room --eye 0.3,1.2,0.4 --look-at -1,0.8,-1 --fov 90 --shade flat", {true, 1}},
      {"forest --fov 30 --depth d32r --far inf", {true, std::tan(15 * degrees)}},
      {"depth-ladder --fov 30 --depth d24", {true, std::tan(15 * degrees)}},
      {"f-glyph --ortho 8 --background 1,1,1", {false, 4}},
      {"cube --ortho 4 --depth d32r --cull front", {false, 2}}};
  for (const auto& [words, lens] : cases) {
    const WorkingDirectory here;
    const Rendered whole = rendered(here, words);
    int seen = 0;
    // This grid of pixels meets every row and column of the picture modulo 4 and 3.
    for (int y = 0; y < kHeight; y += 3) {
      for (int x = y % 4; x < kWidth; x += 7) {
        INFO(words << ", pixel (" << x << ", " << y << ")");
        const Json json = pixel(here, words, x, y);
        const Rgba8 color = whole.color.at(x, y);
        CHECK(json["x"] == x);
        CHECK(json["y"] == y);
        CHECK(json["color"] == Json{color.r, color.g, color.b, color.a});
        const float id = whole.ids.at(x, y);
        REQUIRE(json.contains("triangle") == (id > 0));
        if (id == 0) {
          CHECK(!json.contains("distance"));
          CHECK(!json.contains("world"));
          continue;
        }
        ++seen;
        CHECK(json["triangle"] == id - 1);
        CHECK(json["distance"] == double(whole.distance.at(x, y)));
        const Point3 expected =
            world_point(whole.camera, lens, x, y, double(whole.distance.at(x, y)));
        Point3 apart{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          apart[axis] = json["world"][axis].get<double>() - expected[axis];
        }
        // The projection's entries are floats: at most three roundings of 2^-24 of the distance.
        const double reach = double(whole.distance.at(x, y)) + lens.half_height;
        CHECK(length(apart) < 3 * 0x1p-24 * reach * 2);
      }
    }
    CHECK(seen > 5);
  }
}

TEST_CASE("a triangle's number leads to its instance and its face") {
  const WorkingDirectory here;
  // From left to right: a square, a triangle, and a pentagon that gives three triangles.
  here.write("faces.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
             "v 2 0 0\nv 3 0 0\nv 2.5 1 0\n"
             "v 4 0 0\nv 5 0 0\nv 5 0.6 0\nv 4.5 1 0\nv 4 0.6 0\n"
             "f 1 2 3 4\nf 5 6 7\nf 8 9 10 11 12\n");
  // 40 px show 5.333 units: x = 0.5 is in column 5, 2.5 in column 20 and 4.5 in column 34.
  const std::string words = "faces.obj --eye 2.5,0.5,5 --look-at 2.5,0.5,0 --ortho 4";
  const auto face_at = [&](int x) {
    const Json json = pixel(here, words, x, 15);
    CHECK(json["instance"] == 0);
    return json["face"].get<int>();
  };
  CHECK(face_at(5) == 0);
  CHECK(face_at(20) == 1);
  CHECK(face_at(34) == 2);
  CHECK(pixel(here, words, 20, 15)["triangle"] == 2);
  CHECK(pixel(here, words, 34, 15)["triangle"] >= 3);
  CHECK(pixel(here, words, 34, 15)["triangle"] <= 5);

  // Two boxes of twelve triangles each, the second one to the right.
  write_scene(here, "boxes.glb", box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}),
              {{{1, 1, 1}, {-1, 0, 0}}, {{1, 1, 1}, {1, 0, 0}}});
  const std::string two = "boxes.glb --eye 0,0,5 --look-at 0,0,0 --ortho 3";
  const Json left = pixel(here, two, 10, 15), right = pixel(here, two, 30, 15);
  CHECK(left["instance"] == 0);
  CHECK(right["instance"] == 1);
  CHECK(left["triangle"].get<int>() + 12 == right["triangle"].get<int>());
  CHECK(left["face"] == right["face"]);
  CHECK(left["face"] == left["triangle"]);
}

TEST_CASE("people read the same") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("pixel cube --size 40x30 --at 20,15");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("pixel (20, 15) of cube, 40 x 30\n  colour    (") == 0);
  for (const char* label : {"  triangle  ", "  distance  ", " along the gaze\n", "  world     ("}) {
    CHECK(outcome.out.find(label) != std::string::npos);
  }
  const Outcome background = here.run("pixel cube --size 40x30 --at 0,0 --background 1,0,0.5");
  CHECK(background.exit_code == 0);
  CHECK(
      background.out ==
      "pixel (0, 0) of cube, 40 x 30\n  colour    (255, 0, 128), alpha 255\n"
      "  nothing was drawn here: this is the background\n\n"
      "      triangle  face of mesh, material      fate         distance    depth     pixel after\n"
      "                                            cleared                  ffffffff  (255, 0, "
      "128, 255)\n\n"
      "the picture shows (255, 0, 128, 255), which is the background\n");
  CHECK(here.names().empty());
}

TEST_CASE("the last line has the picture's bytes, whatever the picture shows") {
  const WorkingDirectory here;
  for (const char* words :
       {"room", "room --cull none --near 2", "forest --depth d16", "cube --wireframe",
        "teapot:2 --show normal", "room --show depth", "cube --background 1,1,1"}) {
    const Rendered whole = rendered(here, words);
    for (int y = 1; y < kHeight; y += 9) {
      for (int x = y % 5; x < kWidth; x += 11) {
        const std::string at = std::to_string(x) + "," + std::to_string(y);
        const Outcome outcome =
            here.run(std::string("pixel ") + words + " --size 40x30 --at " + at);
        INFO(words << " at " << at << "\n" << outcome.out << outcome.err);
        REQUIRE(outcome.exit_code == 0);
        const std::string last =
            outcome.out.substr(outcome.out.rfind('\n', outcome.out.size() - 2) + 1);
        const Rgba8 c = whole.color.at(x, y);
        const std::string bytes = "(" + std::to_string(c.r) + ", " + std::to_string(c.g) + ", " +
                                  std::to_string(c.b) + ", " + std::to_string(c.a) + ")";
        CHECK(last.starts_with("the picture shows " + bytes));
        std::istringstream lines(outcome.out);
        for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
      }
    }
  }
}

TEST_CASE("the history in JSON ends in the picture's colour, and --all lists every miss") {
  const WorkingDirectory here;
  int fragments = 0, misses = 0;
  for (int y = 2; y < kHeight; y += 8) {
    for (int x = 3; x < kWidth; x += 8) {
      const Json json = pixel(here, "forest", x, y);
      const Json& history = json["history"];
      CHECK(history["shown"] == json["color"]);
      CHECK(history["complete"] == true);
      if (json.contains("triangle")) {
        const Json& shows = history["events"][history["shows"].get<std::size_t>()];
        CHECK(shows["triangle"] == json["triangle"]);
        CHECK(shows["face"] == json["face"]);
        CHECK(shows["after"] == json["color"]);
        CHECK(shows["distance"] == json["distance"]);
      } else {
        CHECK(history["shows"].is_null());
      }
      fragments += int(history["events"].size());
      misses = std::max(misses, int(history["misses"].size()));
    }
  }
  CHECK(fragments > 20);
  REQUIRE(misses > 3);
  const std::string words = "pixel forest --size 40x30 --at 19,18";
  const int few = int(std::ranges::count(here.run(words).out, '\n'));
  const int all = int(std::ranges::count(here.run(words + " --all").out, '\n'));
  const int more = int(pixel(here, "forest", 19, 18)["history"]["misses"].size()) - 3;
  CHECK(more > 0);
  CHECK(all - few == more);
}

TEST_CASE("JSON goes to a file beside what people read, or alone to standard output") {
  const WorkingDirectory here;
  const Outcome both = here.run("pixel cube --size 40x30 --at 20,15 --json p.json");
  CHECK(both.exit_code == 0);
  CHECK(both.out.find("pixel (20, 15)") == 0);
  const Outcome alone = here.run("pixel cube --size 40x30 --at 20,15 --json -");
  CHECK(alone.out == here.read("p.json"));
  const Json json = Json::parse(alone.out);
  CHECK(json["scene"] == "cube");
  for (const char* key :
       {"x", "y", "color", "triangle", "instance", "mesh", "face", "distance", "world"}) {
    INFO(key);
    CHECK(json.contains(key));
  }
}

TEST_CASE("a line is seen at a distance, and has no triangle's number") {
  const WorkingDirectory here;
  here.write("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  // 30 rows show 2 units: the line, at y = 0, is drawn in row 15, from column 20 to 35.
  const std::string words = "line.obj --eye 0,0,4 --look-at 0,0,0 --ortho 2";
  const Rendered whole = rendered(here, words);
  const Json line = pixel(here, words, 25, 15), beside = pixel(here, words, 25, 20);
  CHECK(!line.contains("triangle"));
  CHECK(line["distance"] == double(whole.distance.at(25, 15)));
  CHECK(line["distance"] == 4.0);
  CHECK(line["world"].size() == 3);
  CHECK(!beside.contains("distance"));
  const Outcome outcome = here.run("pixel " + words + " --size 40x30 --at 25,15");
  CHECK(outcome.out.find("triangle  none: a line or a point\n") != std::string::npos);
  CHECK(outcome.out.find("line/point of mesh 0") != std::string::npos);
  CHECK(outcome.out.find("background") == std::string::npos);
}

TEST_CASE("every command that takes a pixel refuses the same ones in the same words") {
  const WorkingDirectory here;
  for (const std::string option : {"pixel cube --at", "step cube --pick", "inspect cube --pixel"}) {
    const auto refusal = [&](const std::string& place) {
      const Outcome outcome = here.run(option + " " + place + " --size 40x30");
      INFO(option << " " << place << ": " << outcome.err);
      CHECK(outcome.exit_code == 2);
      CHECK(outcome.out.empty());
      CHECK(outcome.err.find(option.substr(option.find("--"))) != std::string::npos);
      return outcome.err;
    };
    for (const char* place : {"-1,0", "1.5,0", "1", "1,2,3", "nan,2", "inf,2", "1,", "1;2", "a,b",
                              "2147483648,2", "99999999999,2"}) {
      CHECK(refusal(place).find(
                std::string("needs X,Y in whole pixels, counted from the top left corner, not '") +
                place + "'") != std::string::npos);
    }
    for (const char* place : {"40,0", "0,30", "2147483647,2147483647"}) {
      CHECK(refusal(place).find(std::string(place) +
                                ": the picture has 40 x 30 pixels, and columns and rows are "
                                "counted from 0; name a pixel in it, or another --size") !=
            std::string::npos);
    }
  }
  CHECK(here.names().empty());
}

TEST_CASE("no pixel, no scene and options of other commands are refused") {
  const WorkingDirectory here;
  const auto check = [&](const std::string& words, const std::string& part) {
    INFO(words);
    check_refused(here.run("pixel " + words), {part});
  };
  check("cube --at 1280,0", "1280 x 720");
  check("cube --size 40x30", "--at");
  check("--at 1,1", "SCENE");
  check("nothing.glb --at 1,1", "nothing.glb");
  check("cube --at 1,1 -o x.png", "-o");
  check("cube --size 40x30 --at 1,1 --near 3 --far 2", "far plane");
  check("cube --size 40x30 --at 1,1 --json nowhere/x.json", "nowhere");
  CHECK(here.names().empty());
}

}  // namespace
}  // namespace glassbox::test
