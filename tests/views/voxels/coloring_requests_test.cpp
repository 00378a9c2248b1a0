// Requests of voxel colouring are carried out or refused.
#include <tests/support/catch.h>

#include "tests/views/voxels/flat_scene.h"

namespace glassbox::views {

using namespace test;

TEST_CASE("what does not fit into memory is computed and refused before it is taken") {
  FlatScene flat = make_flat_scene(8, 1, 4, {-1, 1});
  flat.request.order = ColoringOrder::kCarve;
  flat.request.voxel_size = 8.0 / 4096;
  flat.request.box.high = {8, 8, 8};
  flat.request.most_bytes = std::uint64_t(1) << 30;
  const auto refused = color_voxels(flat.set, flat.request);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message().find("4096 x 4096 x 4096 voxels and 2 pictures take") !=
        std::string::npos);
  flat.request.voxel_size = 1e-3;
  CHECK(color_voxels(flat.set, flat.request).error().message().find("8000 voxels along an axis") !=
        std::string::npos);
  flat.request.voxel_size = 0;
  CHECK_FALSE(color_voxels(flat.set, flat.request));
  flat.request.voxel_size = 1;
  flat.request.levels = 7;
  CHECK_FALSE(color_voxels(flat.set, flat.request));
  flat.set.pictures.clear();
  CHECK_FALSE(color_voxels(flat.set, flat.request));
}

TEST_CASE("cameras whose numbers no float has are refused, and none is taken for a pixel") {
  FlatScene flat = make_flat_scene(8, 1, 4, {-1, 1});
  for (const ColoringOrder order : {ColoringOrder::kSweep, ColoringOrder::kCarve}) {
    for (const Footprint footprint : {Footprint::kCentre, Footprint::kBox, Footprint::kHull}) {
      flat.request.order = order;
      flat.request.settings.sampled = footprint;
      FlatScene far = flat;
      far.set.pictures[1].name = "b.png";
      far.set.pictures[1].camera.centre.z() = -1e300;
      const auto refused = color_voxels(far.set, far.request);
      REQUIRE_FALSE(refused);
      CHECK(refused.error().message().find("b.png: the numbers of its camera are so large") !=
            std::string::npos);
      far = flat;
      far.set.pictures[0].camera.intrinsic(0, 0) = 1e300;
      CHECK_FALSE(color_voxels(far.set, far.request));
    }
  }
  // Footprints at places that are not finite numbers contain no invalid pixel.
  PinholeCamera camera = flat.set.pictures[0].camera;
  camera.centre.z() = -1e300;
  const VoxelGrid grid = grid_of_flat(flat);
  const GridPicture lens = grid_picture(grid, projection_of(camera), 20, 10);
  CHECK_FALSE(is_finite(lens));
  for (const Footprint footprint : {Footprint::kCentre, Footprint::kBox, Footprint::kHull}) {
    int pixels = 0;
    for_each_pixel(lens, centre_of(lens, {1, 0, 1}), footprint, [&](int x, int y) {
      ++pixels;
      CHECK((x >= 0 && y >= 0 && x < 20 && y < 10));
    });
    CHECK(pixels <= 1);
  }
}

TEST_CASE("what a request asks for is done or refused, and the result says what was done") {
  FlatScene flat = make_flat_scene(8, 1, 4, {-1, 1});
  paint(flat, {colored_voxel(3, 0, 2, kRed)});
  flat.request.direction = std::array<int, 2>{0, -1};
  const auto along_x = color_voxels(flat.set, flat.request);
  REQUIRE(along_x);
  CHECK(along_x->direction == std::array<int, 2>{0, -1});
  CHECK(along_x->layers == 8);
  // Cameras inside the box sweep in shells, unless a direction is requested.
  FlatScene inside = flat;
  inside.request.direction.reset();
  for (CalibratedPicture& picture : inside.set.pictures) picture.camera.centre = {4, 0.5, 2};
  CHECK(plan_coloring(inside.set, inside.request)->in_shells);
  inside.request.direction = std::array<int, 2>{2, 1};
  const auto planes = plan_coloring(inside.set, inside.request);
  REQUIRE(planes);
  CHECK_FALSE(planes->in_shells);
  CHECK(planes->traversal == TraversalKind::kEmbedded);

  const auto refusal = [&](const ColoringRequest& request) {
    const auto refused = plan_coloring(flat.set, request);
    REQUIRE_FALSE(refused);
    return refused.error().message();
  };
  ColoringRequest request = flat.request;
  request.order = ColoringOrder::kCarve;
  CHECK(refusal(request).find(
            "--direction: this option is for a single sweep, but carving sweeps along all six") !=
        std::string::npos);
  request.direction.reset();
  request.levels = 1;
  CHECK(refusal(request).find("--levels: this option is for a single sweep") != std::string::npos);
  // Cameras all around the box, without the request for a single sweep.
  flat.set.pictures[0].camera.centre = {-100, 0.5, 2};
  flat.set.pictures[1].camera.centre = {100, 0.5, 2};
  request = flat.request;
  request.order = ColoringOrder::kAuto;
  CHECK(refusal(request).find("cameras all around the box need carving") != std::string::npos);
  request.order = ColoringOrder::kSweep;
  CHECK(plan_coloring(flat.set, request));
}

}  // namespace glassbox::views
