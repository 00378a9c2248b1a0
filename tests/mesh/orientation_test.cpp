// Which side of a surface is its outside: volumes and winding numbers.
#include <glassbox/mesh/orientation.h>

#include <algorithm>
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/scenes.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

Mesh cube_of_side_two() {
  const auto scene = make_builtin("cube");
  REQUIRE(scene);
  return scene->meshes.front();
}

void wind_the_other_way_round(Mesh& mesh) {
  for (const Face& face : mesh.faces) {
    std::reverse(mesh.corners.begin() + face.first, mesh.corners.begin() + face.first + face.count);
  }
}

TEST_CASE("a closed surface has its volume, which is negative if its fronts are inside") {
  Mesh cube = cube_of_side_two();
  REQUIRE(signed_volume(cube));
  CHECK(*signed_volume(cube) == Approx(8));
  // Far from the origin, too.
  Mesh moved = cube;
  for (Point<Object>& p : moved.positions) p = {p.x + 4096, p.y - 4096, p.z + 8192};
  CHECK(signed_volume(moved).value_or(0) == Approx(8));
  wind_the_other_way_round(cube);
  CHECK(signed_volume(cube).value_or(0) == Approx(-8));
}

TEST_CASE("an open surface and one wound inconsistently have no volume") {
  Mesh open = cube_of_side_two();
  open.faces.pop_back();
  CHECK_FALSE(signed_volume(open));
  Mesh mixed = cube_of_side_two();
  const Face& face = mixed.faces.front();
  std::reverse(mixed.corners.begin() + face.first, mixed.corners.begin() + face.first + face.count);
  CHECK_FALSE(signed_volume(mixed));
  CHECK_FALSE(signed_volume(Mesh{}));
}

TEST_CASE("the winding number is 1 inside and 0 outside, and -1 inside a room") {
  Random random(464);
  Mesh cube = cube_of_side_two();
  Mesh room = cube;
  wind_the_other_way_round(room);
  for (int i = 0; i < 500; ++i) {
    const double x = random.between(-3, 3), y = random.between(-3, 3), z = random.between(-3, 3);
    const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
    if (std::abs(largest - 1) < 1e-6) continue;
    CAPTURE(x, y, z);
    const double expected = largest < 1 ? 1 : 0;
    CHECK(winding_number(cube, {x, y, z}) == Approx(expected).margin(1e-9));
    CHECK(winding_number(room, {x, y, z}) == Approx(-expected).margin(1e-9));
  }
  cube.faces.pop_back();
  CHECK(winding_number(cube, {0, 0, 0}) == Approx(5.0 / 6));
}

}  // namespace
}  // namespace glassbox
