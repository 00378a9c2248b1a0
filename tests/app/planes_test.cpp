// Tests --depth-out and --id-out: the values in the planes of the framebuffer, and their order in
// the file.
#include "tests/support/catch.h"

#include <cmath>
#include <limits>
#include <string>

#include "tests/app/scenes.h"
#include "tests/app/working_directory.h"

namespace glassbox::test {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr double kRoundoff = 0x1p-24;

Plane rendered_plane(const WorkingDirectory& here, const std::string& options) {
  const Outcome outcome = here.run("render " + options);
  INFO(options << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return parse_pfm(here.read("plane.pfm"));
}

TEST_CASE(
    "a wall seen in parallel projection is exactly as far as it stands, and nothing else is") {
  const WorkingDirectory here;
  // A wall in the lower left quarter of a picture 4 units high.
  here.write("wall.obj", "v -2 -2 0\nv 0 -2 0\nv 0 0 0\nv -2 0 0\nf 1 2 3 4\n");
  for (const char* depth : {"d32", "d32r", "d24", "d16"}) {
    const Plane plane =
        rendered_plane(here, std::string("wall.obj --size 8x8 --ortho 4 --eye 0,0,5 "
                                         "--look-at 0,0,0 --near 1 --far 9 --depth ") +
                                 depth + " --depth-out plane.pfm");
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        CAPTURE(depth, x, y);
        CHECK(plane.at(x, y) == (x < 4 && y >= 4 ? 5.0f : kNothing));
      }
    }
  }
}

TEST_CASE("the rows of a PFM run bottom-up") {
  const WorkingDirectory here;
  here.write("wall.obj", "v -2 -2 0\nv 2 -2 0\nv 2 -1 0\nv -2 -1 0\nf 1 2 3 4\n");
  rendered_plane(here,
                 "wall.obj --size 4x4 --ortho 4 --eye 0,0,5 --look-at 0,0,0 --id-out plane.pfm");
  const std::string bytes = here.read("plane.pfm");
  const std::string zero(4, '\0');
  // The first row of the file is the wall, at the bottom of the picture; the last three rows are
  // empty.
  CHECK(bytes.substr(bytes.size() - 64, 4) != zero);
  CHECK(bytes.substr(bytes.size() - 48) == std::string(48, '\0'));
}

TEST_CASE(
    "a slanted plane in parallel projection is as far as it stands, within the depth's bound") {
  const WorkingDirectory here;
  // The plane z = x/2 over the whole picture.
  here.write("slope.obj", "v -2 -2 -1\nv 2 -2 1\nv 2 2 1\nv -2 2 -1\nf 1 2 3 4\n");
  const Plane plane = rendered_plane(here,
                                     "slope.obj --size 16x16 --ortho 4 --eye 0,0,5 --look-at 0,0,0 "
                                     "--near 1 --far 9 --depth-out plane.pfm");
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const double expected = 5 - ((x + 0.5) / 4 - 2) / 2;
      // The vertices' depths are exact. Interpolation has an error of up to 8 u for a depth in [0,
      // 1] (raster/interpolate.h), which the range of 8 between the planes magnifies. The last
      // rounding is relative.
      const double bound = 8 * kRoundoff * 8 + kRoundoff * expected;
      CAPTURE(x, y);
      CHECK(std::abs(double(plane.at(x, y)) - expected) <= bound);
    }
  }
}

TEST_CASE("a wall facing a perspective camera is exactly as far as it stands") {
  const WorkingDirectory here;
  here.write("wall.obj", "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n");
  for (const int distance : {1, 2, 4, 8}) {
    const Plane plane =
        rendered_plane(here, "wall.obj --size 9x5 --eye 0,0," + std::to_string(distance) +
                                 " --look-at 0,0,0 --near 0.5 --far inf --depth-out plane.pfm");
    for (const float value : plane.values) CHECK(value == float(distance));
  }
}

TEST_CASE("pixel and distance give back the point of a floor, with near and far 1e5 apart (C-20)") {
  const WorkingDirectory here;
  // The corners are chosen so that they fall on corners of pixels: x = 16 + 16 x/w, y = 16 + 16/w.
  here.write("floor.obj", "v -2 -1 -2\nv 2 -1 -2\nv 8 -1 -8\nv -8 -1 -8\nf 1 2 3 4\n");
  for (const char* depth : {"d32", "d32r"}) {
    const Plane plane =
        rendered_plane(here, std::string("floor.obj --size 32x32 --eye 0,0,0 --look-at "
                                         "0,0,-1 --fov 90 --near 0.001 --far 100 "
                                         "--depth ") +
                                 depth + " --depth-out plane.pfm");
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 32; ++x) {
        const bool on_floor = y >= 18 && y < 24;
        CAPTURE(depth, x, y);
        if (!on_floor) {
          CHECK(plane.at(x, y) == kNothing);
          continue;
        }
        const double w = double(plane.at(x, y));
        // 1/w is within 7 u of the vertices' values (raster/interpolate.h), which are within 2 u of
        // exact, and the reciprocal is rounded: together 10 u of w. The distance may differ from
        // the one that follows from the height, -w (y - 16)/16, by that much only.
        CHECK(std::abs(w * (y + 0.5 - 16) / 16 - 1) <= 10 * kRoundoff);
      }
    }
  }
}

TEST_CASE("triangles are numbered from 1 in the order of the file, polygons taking n - 2 numbers") {
  const WorkingDirectory here;
  // The four columns of the picture: a quad, a triangle without area (not visible), a pentagon, a
  // triangle.
  here.write("row.obj",
             "v -4 -1 0\nv -2 -1 0\nv -2 1 0\nv -4 1 0\nf 1 2 3 4\n"
             "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 5 6 7\n"
             "v 0 -1 0\nv 2 -1 0\nv 2 1 0\nv 1 1 0\nv 0 1 0\nf 8 9 10 11 12\n"
             "v 2 -1 0\nv 4 -1 0\nv 4 3 0\nf 13 14 15\n");
  const Plane plane = rendered_plane(here,
                                     "row.obj --size 64x16 --ortho 2 --eye 0,0,5 --look-at 0,0,0 "
                                     "--id-out plane.pfm");
  bool seen[9] = {};
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 64; ++x) {
      const float id = plane.at(x, y);
      REQUIRE((id >= 0 && id <= 7 && id == std::floor(id)));
      seen[int(id)] = true;
      const int column = x / 16;
      CAPTURE(x, y, id);
      if (column == 0) CHECK((id == 1 || id == 2));
      if (column == 1) CHECK(id == 0);
      if (column == 2) CHECK((id >= 4 && id <= 6));
      if (column == 3) CHECK((id == 7 || id == 0));
    }
  }
  for (const int id : {0, 1, 2, 4, 5, 6, 7}) {
    INFO("id " << id);
    CHECK(seen[id]);
  }
}

TEST_CASE("instances of one mesh have numbers of their own") {
  const WorkingDirectory here;
  write_scene(here, "row.glb",
              triangles({{-1, -1, 0},
                         {1, -1, 0},
                         {1, 1, 0},  //
                         {-1, -1, 0},
                         {1, 1, 0},
                         {-1, 1, 0}}),
              {{{1, 1, 1}, {-3, 0, 0}}, {{1, 1, 1}, {-1, 0, 0}}, {{1, 1, 1}, {3, 0, 0}}});
  const Plane plane = rendered_plane(here,
                                     "row.glb --size 32x8 --ortho 2 --eye 0,0,5 --look-at 0,0,0 "
                                     "--id-out plane.pfm");
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 32; ++x) {
      const int tile = x / 8;
      // The second triangle of a pair is the upper left one. Samples on the diagonal are on the
      // lower triangle's left edge or the upper one's right edge: a left edge owns them.
      const bool lower = x % 8 > 7 - y;
      const bool diagonal = x % 8 == 7 - y;
      const int first = tile < 2 ? 1 + 2 * tile : 5;
      CAPTURE(x, y);
      if (tile == 2) {
        CHECK(plane.at(x, y) == 0);
      } else if (diagonal) {
        CHECK((plane.at(x, y) == float(first) || plane.at(x, y) == float(first + 1)));
      } else {
        CHECK(plane.at(x, y) == float(lower ? first : first + 1));
      }
    }
  }
}

}  // namespace
}  // namespace glassbox::test
