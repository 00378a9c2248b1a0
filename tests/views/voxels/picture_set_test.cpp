// Rings of pictures as files: written rings are read again, and invalid files are refused.
#include <tests/support/catch.h>

#include <filesystem>
#include <fstream>

#include <glassbox/images/write.h>

#include "tests/images/temporary_directory.h"
#include "tests/views/voxels/rig.h"

namespace glassbox::views {
namespace {

using glassbox::test::TemporaryDirectory;

std::string refusal(const auto& result) {
  REQUIRE_FALSE(result);
  return result.error().message();
}

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

RingOptions small_ring(int views) {
  RingOptions options;
  options.views = views;
  options.width = options.height = 32;
  return options;
}

}  // namespace

TEST_CASE("a ring that is written is read again, picture for picture") {
  const TemporaryDirectory directory;
  const PictureSet set = test::ring_of(test::speckled_sphere(8, 1), small_ring(5));
  const std::string folder = directory.file("ring");
  REQUIRE(write_picture_set(folder, set));
  for (const std::string& path : {folder, folder + "/ring_par.txt"}) {
    const auto read = read_picture_set(path, {});
    REQUIRE(read);
    REQUIRE(read->pictures.size() == 5);
    CHECK(read->box->low == set.box->low);
    CHECK(read->box->high == set.box->high);
    for (std::size_t i = 0; i < 5; ++i) {
      const CalibratedPicture &again = read->pictures[i], &picture = set.pictures[i];
      CHECK(again.name == picture.name);
      CHECK(again.color == picture.color);
      CHECK(again.matte == picture.matte);
      CHECK(again.camera.intrinsic == picture.camera.intrinsic);
      // The camera's centre is converted to t and back, and the rotation is repaired to the nearest
      // one: a few roundings.
      CHECK((again.camera.centre - picture.camera.centre).norm() < 1e-13);
    }
  }
  PictureSetOptions some;
  some.chosen = {3, 0};
  CHECK(read_picture_set(folder, some)->pictures[0].name == "view003.png");
  some.chosen = {5};
  CHECK(refusal(read_picture_set(folder, some)).find("there is no number 6") != std::string::npos);
  some.chosen = {};
  some.most_bytes = 32 * 32 * 4 * 4;
  CHECK(refusal(read_picture_set(folder, some)).find("allow more with --max-mb") !=
        std::string::npos);
}

TEST_CASE(
    "a ring that is written over another has nothing of it, and one that is not whole no cameras") {
  const TemporaryDirectory directory;
  const std::string folder = directory.file("ring");
  const PictureSet set = test::ring_of(test::speckled_sphere(8, 1), small_ring(3));
  REQUIRE(write_picture_set(folder, set));
  PictureSet bare = set;
  bare.pictures.pop_back();
  bare.pictures[0].matte = {};
  bare.box.reset();
  // A mask may also have the name that COLMAP gives it.
  std::filesystem::copy(folder + "/masks/view001.png", folder + "/masks/view000.png.png");
  REQUIRE(write_picture_set(folder, bare));
  const auto again = read_picture_set(folder, {});
  REQUIRE(again);
  CHECK(again->pictures.size() == 2);
  CHECK(again->pictures[0].matte.pixels.empty());
  CHECK(again->pictures[1].matte == set.pictures[1].matte);
  CHECK_FALSE(again->box);
  // The second picture cannot be written, and the first ring's cameras are removed.
  std::filesystem::remove(folder + "/view001.png");
  std::filesystem::create_directories(folder + "/view001.png/full");
  CHECK_FALSE(write_picture_set(folder, set));
  CHECK(refusal(read_picture_set(folder, {})).find("has no cameras") != std::string::npos);
}

TEST_CASE(
    "the cameras of a ring see the whole scene, and are those that its pictures were drawn with") {
  const Scene scene = test::speckled_sphere(8, 2);
  for (const double elevation : {-60.0, 0.0, 35.0}) {
    RingOptions options = small_ring(4);
    options.elevations = {elevation};
    options.pair_separation = 0.2;
    const auto views = ring_views(scene, options);
    REQUIRE(views);
    REQUIRE(views->size() == 8);
    CHECK((*views)[0].named.picture == "view000_left.png");
    const Vector3d apart = (*views)[1].named.camera.centre - (*views)[0].named.camera.centre;
    CHECK(std::abs(apart.norm() - 0.2) < 1e-12);
    for (const RingView& view : *views) {
      // The camera of the engine's matrices is the one that is written to the file; nothing is
      // rounded to float here.
      const auto again = camera_of(view.view);
      REQUIRE(again);
      CHECK((again->intrinsic - view.named.camera.intrinsic).cwiseAbs().maxCoeff() < 1e-9);
      CHECK((again->centre - view.named.camera.centre).norm() < 1e-9);
      for (const Point<Object>& p : scene.meshes[0].positions) {
        const Vector3d at = project(view.named.camera, {double(p.x), double(p.y), double(p.z)});
        CHECK((at.z() > 0 && at.x() > 0 && at.y() > 0 && at.x() < 32 && at.y() < 32));
      }
    }
  }
  RingOptions wrong = small_ring(0);
  CHECK_FALSE(ring_views(scene, wrong));
  wrong = small_ring(4);
  wrong.elevations = {90};
  CHECK_FALSE(ring_views(scene, wrong));
  wrong = small_ring(4);
  wrong.arc_degrees = 0;
  CHECK_FALSE(ring_views(scene, wrong));
  CHECK_FALSE(ring_views(Scene{}, small_ring(4)));
  const auto refusal_of = [&](auto change) {
    RingOptions options = small_ring(4);
    change(options);
    return refusal(ring_views(scene, options));
  };
  CHECK(refusal_of([](RingOptions& o) { o.start_degrees = NAN; }).starts_with("--start"));
  CHECK(refusal_of([](RingOptions& o) { o.up = {1e200, 0, 0}; }).starts_with("--up"));
  CHECK(
      refusal_of([](RingOptions& o) { o.target = Vector3d(0, NAN, 0); }).starts_with("--look-at"));
}

TEST_CASE("pictures and masks that do not fit their cameras are refused, with the file's name") {
  const TemporaryDirectory directory;
  const std::string folder = directory.file("ring");
  const PictureSet set = test::ring_of(test::speckled_sphere(8, 1), small_ring(2));
  REQUIRE(write_picture_set(folder, set));
  REQUIRE(write_image(folder + "/masks/view001.png", Image<Rgba8>(31, 32)));
  CHECK(refusal(read_picture_set(folder, {})).find("is 31 x 32, but its picture is 32 x 32") !=
        std::string::npos);
  std::filesystem::remove(folder + "/view001.png");
  CHECK(refusal(read_picture_set(folder, {})).find("'images/view001.png' does not exist") !=
        std::string::npos);
  REQUIRE(write_picture_set(folder, set));
  write(folder + "/box.txt", "0 0 0\n1 0 1\n");
  CHECK(refusal(read_picture_set(folder, {})).find("the box is empty") != std::string::npos);
  std::filesystem::remove(folder + "/box.txt");

  const std::string identity = " 100 0 16 0 100 16 0 0 1 1 0 0 0 1 0 0 0 1 0 0 2\n";
  const auto with = [&](const std::string& text) {
    write(folder + "/ring_par.txt", text);
    return refusal(read_picture_set(folder, {}));
  };
  CHECK(with("3\nview000.png" + identity).find("announces 3 cameras, but there are 1") !=
        std::string::npos);
  CHECK(with("0\n").find("has 0 cameras") != std::string::npos);
  CHECK(with("1\n../view000.png" + identity).find("does not exist") != std::string::npos);
  CHECK(with("1\n/etc/passwd" + identity).find("does not exist") != std::string::npos);
  // A matrix K without a focal length, then a matrix R that mirrors.
  CHECK(with("1\nview000.png 0 0 16 0 100 16 0 0 1 1 0 0 0 1 0 0 0 1 0 0 2\n")
            .find("the intrinsic matrix K is wrong") != std::string::npos);
  CHECK(with("1\nview000.png 100 0 16 0 100 16 0 0 1 1 0 0 0 1 0 0 0 -1 0 0 2\n")
            .find("R is a mirror") != std::string::npos);
  std::filesystem::remove(folder + "/ring_par.txt");
  CHECK(refusal(read_picture_set(folder, {})).find("has no cameras") != std::string::npos);
  CHECK_FALSE(read_picture_set(directory.file("nowhere"), {}));
}

}  // namespace glassbox::views
