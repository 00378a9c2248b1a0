// The position of things in the world must not show in the picture: large offsets, mirrored and
// squeezed nodes, far planes.
#include "tests/support/catch.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/app/scenes.h"
#include "tests/app/working_directory.h"

#include <glassbox/images/read.h>

namespace glassbox::test {
namespace {

struct Picture {
  Image<Rgba8> color;
  std::string depth, ids;  // bytes of the PFM files
};

Picture picture_of_world(const WorkingDirectory& here, const std::string& options) {
  const Outcome outcome =
      here.run("render " + options + " --size 160x120 -o p.png --depth-out d.pfm --id-out i.pfm");
  INFO(options << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto image = read_image(here.file("p.png"));
  REQUIRE(image);
  return {*image, here.read("d.pfm"), here.read("i.pfm")};
}

std::string camera_at(double offset, const std::string& more) {
  char text[200];
  std::snprintf(text, sizeof text, "--eye %.17g,%.17g,%.17g --look-at %.17g,%.17g,%.17g ",
                offset + 1.5, offset + 1.25, offset + 2, offset, offset, offset);
  return text + more;
}

void check_same(const Picture& a, const Picture& b) {
  CHECK(a.color == b.color);
  CHECK(a.depth == b.depth);
  CHECK(a.ids == b.ids);
}

// Offsets of all sizes for which the differences of coordinates are exact.
const std::vector<double> kOffsets{100, 65536, 1e6, 6.378e6, 16777216};

TEST_CASE("a cube of 1 m placed far away by its node does not shake (C-13, C-14)") {
  const Mesh cube = box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
  const WorkingDirectory here;
  for (const char* lens : {"--near 0.5 --far 10", "--ortho 2 --near 0.5 --far 10", "--near 0.5"}) {
    write_scene(here, "near.glb", cube, {Placement{}});
    const Picture at_origin = picture_of_world(here, "near.glb " + camera_at(0, lens));
    for (const double offset : kOffsets) {
      write_scene(here, "away.glb", cube, {{{1, 1, 1}, {offset, offset, offset}}});
      INFO("offset " << offset << ", " << lens);
      const Picture away = picture_of_world(here, "away.glb " + camera_at(offset, lens));
      CHECK(away.color == at_origin.color);
      CHECK(away.ids == at_origin.ids);
    }
  }
}

TEST_CASE("a cube of 1 m whose vertices are far away does not shake (C-13)") {
  const WorkingDirectory here;
  const std::string lens = "--near 0.5 --far 10";
  write_scene(here, "near.glb", box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}), {Placement{}});
  const Picture at_origin = picture_of_world(here, "near.glb " + camera_at(0, lens));
  for (const double offset : {100.0, 65536.0, 1e6, 4194304.0}) {
    // Multiples of 1/2 are exact floats up to 2^23, so the corners are where they should be.
    const float low = float(offset - 0.5);
    const float high = float(offset + 0.5);
    REQUIRE(double(low) == offset - 0.5);
    write_scene(here, "away.glb", box({low, low, low}, {high, high, high}), {Placement{}});
    INFO("offset " << offset);
    const Picture away = picture_of_world(here, "away.glb " + camera_at(offset, lens));
    CHECK(away.color == at_origin.color);
    CHECK(away.ids == at_origin.ids);
  }
}

// A tetrahedron without any symmetry.
const std::vector<Triple> kCorners{
    {0, 0, 0.75f}, {1, 0.25f, 0}, {-0.25f, 1, 0}, {-0.5f, -0.75f, -0.5f}};
std::vector<Triple> tetrahedron(bool mirrored) {
  std::vector<Triple> positions;
  constexpr int kFaces[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  for (const auto& face : kFaces) {
    for (const int k : {0, 1, 2}) {
      Triple p = kCorners[std::size_t(face[mirrored ? (3 - k) % 3 : k])];
      if (mirrored) p[0] = -p[0];
      positions.push_back(p);
    }
  }
  return positions;
}

TEST_CASE("a node that mirrors shows the mirrored mesh, its fronts outside and lit (C-17)") {
  const WorkingDirectory here;
  write_scene(here, "node.glb", triangles(tetrahedron(false)), {{{-1, 1, 1}, {0, 0, 0}}});
  write_scene(here, "mesh.glb", triangles(tetrahedron(true)), {Placement{}});
  for (const char* options : {"--cull back", "--cull front", "--cull none", "--show normal"}) {
    const std::string camera = camera_at(0, std::string("--near 0.5 --far 10 ") + options);
    INFO(options);
    check_same(picture_of_world(here, "node.glb " + camera),
               picture_of_world(here, "mesh.glb " + camera));
  }
  // The two pictures must differ, so that culling the wrong side would be noticed.
  const std::string camera = camera_at(0, "--near 0.5 --far 10 ");
  CHECK(picture_of_world(here, "node.glb " + camera + "--cull back").depth !=
        picture_of_world(here, "node.glb " + camera + "--cull front").depth);
}

TEST_CASE("a mirrored node is lit like the mirror image of the other one (C-17)") {
  const WorkingDirectory here;
  write_scene(here, "plain.glb", triangles(tetrahedron(false)), {Placement{}});
  write_scene(here, "mirrored.glb", triangles(tetrahedron(false)), {{{-1, 1, 1}, {0, 0, 0}}});
  // The picture shows normals, because the headlight's shading is not symmetric.
  const std::string camera = "--eye 0,0,4 --look-at 0,0,0 --near 0.5 --far 10 --show normal";
  const Image<Rgba8> plain = picture_of_world(here, "plain.glb " + camera).color;
  const Image<Rgba8> mirrored = picture_of_world(here, "mirrored.glb " + camera).color;
  const Rgba8 background{26, 31, 38, 255};
  int compared = 0;
  for (int y = 0; y < plain.height; ++y) {
    for (int x = 0; x < plain.width; ++x) {
      const Rgba8& a = plain.at(x, y);
      const Rgba8& b = mirrored.at(plain.width - 1 - x, y);
      // Samples exactly on an edge belong to the other face in the mirror image.
      if (a == background || b == background || a.g != b.g || a.b != b.b) continue;
      ++compared;
      // Red is round(255 (n_x + 1)/2): the two sum to 255, or to 256 if both are halfway and
      // rounded up.
      CHECK((a.r + b.r == 255 || a.r + b.r == 256));
    }
  }
  CHECK(compared > 1000);
}

// Returns the green of the middle pixel, which the square covers.
int green_at_centre(const WorkingDirectory& here, const std::string& scene,
                    const std::string& shade) {
  const Picture picture = picture_of_world(
      here, scene + " --eye 0,0,8 --look-at 0,0,0 --ortho 1 --near 1 --far 20 --shade " + shade);
  return picture.color.at(80, 60).g;
}

TEST_CASE("normals follow a squeezed node by the cofactor matrix (C-16)") {
  const WorkingDirectory here;
  // A plane that rises steeply towards the left: z = -4 x, with its normal along (4, 0, 1). The
  // node squeezes z to 1/8.
  constexpr double kSqueeze = 0.125;
  const auto square = [](double slope) {
    const auto at = [&](float x, float y) { return Triple{x, y, float(-slope * double(x))}; };
    return std::vector<Triple>{at(-1, -1), at(1, -1), at(1, 1), at(-1, -1), at(1, 1), at(-1, 1)};
  };
  const auto unit = [](double x, double z) {
    const double length = std::sqrt(x * x + z * z);
    return Triple{float(x / length), 0, float(z / length)};
  };
  const auto six = [](const Triple& n) { return std::vector<Triple>(6, n); };
  write_scene(here, "squeezed.glb", triangles(square(4), six(unit(4, 1))),
              {{{1, 1, kSqueeze}, {0, 0, 0}}});
  write_scene(here, "flat.glb", triangles(square(4)), {{{1, 1, kSqueeze}, {0, 0, 0}}});
  write_scene(here, "expected.glb", triangles(square(0.5), six(unit(0.5, 1))), {Placement{}});
  // The wrong result if the normal is multiplied by the node's matrix like a position.
  write_scene(here, "wrong.glb", triangles(square(0.5), six(unit(4, kSqueeze))), {Placement{}});
  for (const char* shade : {"flat", "gouraud", "phong"}) {
    const int expected = green_at_centre(here, "expected.glb", shade);
    INFO("--shade " << shade);
    // The directions agree within 10 u (C-16), which changes the light by a relative 1e-6: at most
    // one step of a byte.
    CHECK(std::abs(green_at_centre(here, "squeezed.glb", shade) - expected) <= 1);
    CHECK(std::abs(green_at_centre(here, "flat.glb", shade) - expected) <= 1);
    if (std::string(shade) != "flat") {
      CHECK(std::abs(green_at_centre(here, "wrong.glb", shade) - expected) > 20);
    }
  }
}

TEST_CASE("the picture does not change as the far plane moves away to infinity (C-10)") {
  const WorkingDirectory here;
  write_scene(here, "cube.glb", box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}), {Placement{}});
  for (const char* depth : {"d32", "d32r", "d24"}) {
    const std::string start = std::string("cube.glb --depth ") + depth + " ";
    const Picture infinite = picture_of_world(here, start + camera_at(0, "--near 1 --far inf"));
    for (const char* far : {"1e3", "1e6", "1e9", "1e30"}) {
      INFO("depth " << depth << ", far " << far);
      check_same(picture_of_world(here, start + camera_at(0, std::string("--near 1 --far ") + far)),
                 infinite);
    }
  }
}

}  // namespace
}  // namespace glassbox::test
