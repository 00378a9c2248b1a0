// Voxel colouring of rings: pictures of a ball whose surface is known.
#include <tests/support/catch.h>

#include "tests/views/voxels/flat_scene.h"
#include "tests/views/voxels/rig.h"

namespace glassbox::views {

using namespace test;

TEST_CASE("every target and every number of threads finds the same voxels, in every way there is") {
  const PictureSet set = ring_of(speckled_sphere(6, 3), ring_options(7, {35}, 64));
  struct Way {
    const char* name;
    void (*choose)(ColoringRequest&);
  };
  const Way ways[] = {
      {"sigma", [](ColoringRequest&) {}},
      {"adaptive", [](ColoringRequest& r) { r.settings.consistency = Consistency::kAdaptive; }},
      {"ratio, without masks of two pictures",
       [](ColoringRequest& r) {
         r.settings.consistency = Consistency::kLikelihood;
         r.settings.noise = 20;
       }},
      {"lab", [](ColoringRequest& r) { r.settings.space = ColorSpace::kLab; }},
      {"levels", [](ColoringRequest& r) { r.levels = 1; }},
      {"carving", [](ColoringRequest& r) { r.order = ColoringOrder::kCarve; }},
      {"hulls, voxel after voxel", [](ColoringRequest& r) {
         r.settings.sampled = r.settings.hidden = Footprint::kHull;
         r.settings.update = OcclusionUpdate::kVoxel;
       }}};
  for (const Way& way : ways) {
    ColoringRequest request = request_for(set, 0.1);
    way.choose(request);
    request.settings.target = Target::kScalar;
    request.settings.threads = 1;
    const auto first = color_voxels(set, request);
    REQUIRE(first);
    INFO(way.name);
    CHECK(first->voxels.size() > 100);
    for (const Target target : available_targets()) {
      for (const int threads : {1, 3}) {
        request.settings.target = target;
        request.settings.threads = threads;
        const auto again = color_voxels(set, request);
        INFO(name_of(target) << ", " << threads << " threads");
        CHECK(again->voxels == first->voxels);
        CHECK(again->counts == first->counts);
        CHECK(again->examined == first->examined);
      }
    }
  }
}

TEST_CASE("with masks no voxel is coloured outside of the visual hull (S1-20)") {
  const PictureSet set = ring_of(speckled_sphere(6, 5), ring_options(9, {30}, 64));
  for (const ColoringOrder order : {ColoringOrder::kSweep, ColoringOrder::kCarve}) {
    ColoringRequest request = request_for(set, 0.05);
    request.order = order;
    const auto found = color_voxels(set, request);
    REQUIRE(found);
    CHECK(found->voxels.size() > 200);
    std::size_t outside = 0;
    for (const ColoredVoxel& voxel : found->voxels) {
      for (const CalibratedPicture& picture : set.pictures) {
        const Vector3d p = project(picture.camera, found->grid.centre(voxel.at));
        // A centre within 1e-3 px of a pixel's border may be looked up in the neighbouring pixel,
        // since rows are computed in float.
        const auto near_border = [](double u) { return std::abs(u - std::round(u)) < 1e-3; };
        if (near_border(p.x()) || near_border(p.y())) continue;
        REQUIRE((p.x() > 0 && p.y() > 0 && p.x() < 64 && p.y() < 64));
        outside += picture.matte.at(int(p.x()), int(p.y())) == 0;
      }
    }
    CHECK(outside == 0);
  }
}

TEST_CASE(
    "a ring around the object has no order: one sweep is wrong, and carving from all sides is not "
    "(C-90)") {
  const Scene scene = speckled_sphere(6, 6);
  const PictureSet set = ring_of(scene, ring_options(16, {0}, 48));
  ColoringRequest request = request_for(set, pixel_size(set));
  request.settings.threshold = 60;
  Coloring carved, swept;
  const double by_carving = iou_of(scene, set, request, &carved);
  CHECK(carved.traversal == TraversalKind::kSurrounded);
  CHECK(carved.order == ColoringOrder::kCarve);
  request.order = ColoringOrder::kSweep;
  const double by_sweep = iou_of(scene, set, request, &swept);
  INFO("IoU " << by_carving << " and " << by_sweep);
  CHECK(by_carving > 0.8);
  CHECK(by_sweep < by_carving - 0.05);
}

TEST_CASE(
    "a textured ball from all around, at voxels of a pixel: IoU 0.95, and what two pictures see is "
    "within 3 voxels") {
  const Scene scene = speckled_sphere(6, 7);
  const PictureSet set = ring_of(scene, ring_options(8, {50, 0, -50}, 48));
  ColoringRequest request = request_for(set, pixel_size(set));
  request.settings.threshold = 60;
  Coloring found;
  CHECK(iou_of(scene, set, request, &found) >= 0.95);
  const VisibleSurface seen = visible_surface(set, true_distances(scene, set).value(), found.grid);
  CHECK(surface_errors(found.voxels, seen).from_truth_most <= 3);
  CHECK(seen.in_two_pictures.size() > 10000);
  // With a threshold below the variation of the speckle within a pixel, one wrongly carved voxel
  // exposes those behind it.
  request.settings.threshold = 25;
  CHECK(iou_of(scene, set, request) < 0.1);
}

TEST_CASE("coarse to fine finds nearly all, and looks at a small part") {
  const PictureSet set = ring_of(speckled_sphere(6, 9), ring_options(12, {45}, 96));
  ColoringRequest request = request_for(set, pixel_size(set));
  request.settings.threshold = 60;
  const auto full = color_voxels(set, request);
  request.levels = 2;
  const auto fine = color_voxels(set, request);
  REQUIRE(fine);
  const auto all = positions_of(full->voxels), some = positions_of(fine->voxels);
  std::size_t both = 0;
  for (const VoxelTuple& position : some) both += all.contains(position);
  CHECK(double(both) > 0.9 * double(all.size()));
  CHECK(fine->examined < full->examined / 2);
}

TEST_CASE("carving that is stopped says so") {
  const PictureSet set = ring_of(speckled_sphere(6, 6), ring_options(8, {0}, 32));
  ColoringRequest request = request_for(set, 0.15);
  request.order = ColoringOrder::kCarve;
  const auto whole = color_voxels(set, request);
  REQUIRE(whole);
  CHECK(whole->is_finished);
  REQUIRE(whole->passes >= 2);
  request.most_passes = 1;
  const auto stopped = color_voxels(set, request);
  CHECK_FALSE(stopped->is_finished);
  CHECK(stopped->passes == 1);
}

}  // namespace glassbox::views
