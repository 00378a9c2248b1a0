// The surface of a disparity map in space: the mesh, its file, and the view that shows it again.
#include <tests/support/catch.h>

#include <cfenv>
#include <cmath>
#include <string>

#include <glassbox/mesh/ply/load.h>

#include "tests/views/matching/known_pairs.h"
#include "views/matching/disparity_errors.h"
#include "views/matching/match.h"
#include "views/matching/surface.h"
#include "views/matching/winner.h"

namespace glassbox::views {
namespace {

// Two walls of six by four pixels, one behind the other; one pixel of the nearer wall is unknown.
struct TwoWalls {
  Image<Rgba8> picture = noise(12, 4, 3);
  Image<float> disparity{12, 4, 10};
  Calibration calibration{100, 0.5, 2, Principal{5, 3}};

  TwoWalls() {
    for (int y = 0; y < 4; ++y) {
      for (int x = 6; x < 12; ++x) disparity.at(x, y) = 3;
    }
    disparity.at(0, 0) = kNoDisparity;
  }
};

TEST_CASE(
    "S2-13: a pixel's point lies on its ray at f B/(d + offset), and neighbours are joined on one "
    "surface alone") {
  const TwoWalls walls;
  const Surface surface = surface_of(walls.picture, walls.disparity, walls.calibration);
  CHECK(surface.vertices.size() == 47);
  // Each wall has 5 x 3 squares of two triangles; one square of the first wall has lost a triangle.
  CHECK(surface.triangles.size() == 59);
  const Surface::Vertex& last = surface.vertices.back();
  // Z = 100 * 0.5/5 = 10; floats of numbers below 16 have errors of 2^-20.
  CHECK(std::abs(double(last.x) - (11.5 - 5) * 0.1) < 1e-6);
  CHECK(std::abs(double(last.y) + (3.5 - 3) * 0.1) < 1e-6);
  CHECK(last.z == -10);
  for (const auto& [a, b, c] : surface.triangles) {
    const auto& [p, q, r] =
        std::tuple(surface.vertices[a], surface.vertices[b], surface.vertices[c]);
    CHECK((p.z == q.z && q.z == r.z));
    // Counter-clockwise as seen from the origin.
    CHECK((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) > 0);
  }
}

TEST_CASE("the file of a surface is one that the program reads, with the picture's colours") {
  const TwoWalls walls;
  const Surface surface = surface_of(walls.picture, walls.disparity, walls.calibration);
  const std::vector<std::byte> bytes = encode_ply(surface, "a surface");
  const auto scene =
      load_ply_memory(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  REQUIRE(scene);
  const Mesh& mesh = scene->meshes.front();
  CHECK(mesh.positions.size() == surface.vertices.size());
  CHECK(mesh.colors.size() == surface.vertices.size());
  CHECK(mesh.corners.size() == 3 * surface.triangles.size());
  CHECK(scene->warnings.empty());
}

TEST_CASE("the view of a surface holds it, and is what the camera saw") {
  const TwoWalls walls;
  const Surface surface = surface_of(walls.picture, walls.disparity, walls.calibration);
  const auto view = view_of(surface, walls.calibration, 12, 4);
  REQUIRE(view);
  // Depths are 50/12 and 50/5.
  CHECK(view->near < 50 / 12.0);
  CHECK(view->far > 10);
  const double scale = view->near / 100;
  CHECK(view->left == Approx(-5 * scale));
  CHECK(view->right == Approx(7 * scale));
  CHECK(view->top == Approx(3 * scale));
  CHECK(view->bottom == Approx(-1 * scale));
  const Surface nothing =
      surface_of(walls.picture, Image<float>(12, 4, kNoDisparity), walls.calibration);
  CHECK_FALSE(view_of(nothing, walls.calibration, 12, 4));
}

TEST_CASE(
    "pixels near a jump of more than two are those within four of it; what is unknown is not "
    "subtracted") {
  Image<float> truth(30, 12, 5);
  for (int y = 0; y < 12; ++y) {
    for (int x = 15; x < 30; ++x) truth.at(x, y) = x < 20 ? 7.5f : kNoDisparity;
  }
  std::feclearexcept(FE_ALL_EXCEPT);
  const Image<std::uint8_t> near = near_discontinuity(truth);
  CHECK(std::fetestexcept(FE_INVALID) == 0);
  // The jump is between columns 14 and 15; unknown pixels are not jumps.
  for (int x = 0; x < 30; ++x) {
    INFO(x);
    CHECK(int(near.at(x, 6)) == int(x >= 10 && x <= 19));
  }
  truth = Image<float>(30, 12, 5);
  for (int x = 15; x < 30; ++x) truth.at(x, 3) = 7;
  for (const std::uint8_t one : near_discontinuity(truth).pixels) CHECK(int(one) == 0);
}

TEST_CASE("what a picture does not show has no disparity, on either side") {
  Image<Rgba8> left = noise(90, 40, 7), right = moved_left(left, 11, 8);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 20; ++x) left.at(x, y) = {0, 0, 0, 0};
    for (int x = 60; x < 90; ++x) right.at(x, y) = {0, 0, 0, 0};
  }
  for (auto& [name, settings] : settings_of_every_path({0, 20})) {
    settings.fill = false;
    const auto match = match_pictures(left, right, settings);
    REQUIRE(match);
    INFO(name);
    for (int x = 0; x < 20; ++x) CHECK(match->disparity.at(x, 20) == kNoDisparity);
    // Columns from 72 on correspond to 61 and more of the right picture, which is empty there. Near
    // that border windows reach into the empty part, so a pixel or two may differ.
    for (int x = 74; x < 88; ++x) CHECK(match->disparity.at(x, 20) == kNoDisparity);
    CHECK(std::abs(match->disparity.at(45, 20) - 11) < 0.1f);
  }
}

TEST_CASE("kept sums are those that the winner was sought in") {
  const Image<Rgba8> left = noise(60, 70, 5), right = moved_left(left, 6, 6);
  for (auto& [name, settings] : settings_of_every_path({0, 15})) {
    settings.median = settings.smooth = settings.subpixel = settings.fill = false;
    settings.left_right.reset();
    settings.keep_sums = true;
    const auto match = match_pictures(left, right, settings);
    REQUIRE(match);
    INFO(name);
    for (const auto& [x, y] : {std::pair{30, 5}, std::pair{59, 69}, std::pair{20, 64}}) {
      const std::uint16_t* sums = match->sums.at(x, y);
      CHECK(float(std::min_element(sums, sums + 16) - sums) == match->disparity.at(x, y));
    }
  }
}

}  // namespace
}  // namespace glassbox::views
