// Rings of pictures as files: written rings are read again, and invalid files are refused.
#include <tests/support/catch.h>

#include <filesystem>
#include <fstream>

#include <glassbox/images/write.h>

#include "tests/images/temporary_directory.h"
#include "tests/views/voxels/rig.h"
#include "views/files/colmap_file.h"

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

TEST_CASE("COLMAP's text files give the cameras that they describe") {
  const std::string cameras =
      "# comment\n1 PINHOLE 640 480 500 510 320 240\n2 SIMPLE_PINHOLE 64 48 50 32 24\n"
      "3 SIMPLE_RADIAL 64 48 50 32 24 0.1\n4 FISHEYE 64 48 50 32 24\n5 PINHOLE 64 48 0 50 32 24\n";
  const auto two = cameras.substr(0, cameras.find("3 SIMPLE"));
  const auto read = parse_colmap(two,
                                 "# two lines each\n"
                                 "7 0.7071067811865476 0 0.7071067811865476 0 1 2 3 1 b.png\n"
                                 "10 10 -1 20 20 3\n"
                                 "2 1 0 0 0 0 0 4 2 a.png\n\n");
  REQUIRE(read);
  REQUIRE(read->size() == 2);
  CHECK((*read)[0].picture == "a.png");
  CHECK((*read)[0].camera.intrinsic(0, 0) == 50);
  CHECK((*read)[0].camera.centre == Vector3d(0, 0, -4));
  // A quarter turn about y turns the world's z into the camera's x.
  const PinholeCamera& turned = (*read)[1].camera;
  CHECK(turned.intrinsic(1, 1) == 510);
  CHECK((turned.camera_from_world * Vector3d::UnitZ() - Vector3d::UnitX()).norm() < 1e-15);
  CHECK((turned.camera_from_world * turned.centre + Vector3d(1, 2, 3)).norm() < 1e-14);

  const auto refused = [&](const std::string& lens_text, const std::string& image_text) {
    return refusal(parse_colmap(lens_text, image_text));
  };
  const std::string image = "1 1 0 0 0 0 0 4 ";
  CHECK(refused(cameras, "").find("the camera has distortion") != std::string::npos);
  CHECK(refused("4 FISHEYE 64 48 50 32 24\n", "").find("'FISHEYE' is not a pinhole model") !=
        std::string::npos);
  CHECK(refused("5 PINHOLE 64 48 0 50 32 24\n", "").find("a focal length is not positive") !=
        std::string::npos);
  CHECK(refused("5 PINHOLE 64 48 50\n", "").find("has 5 of the 8 words") != std::string::npos);
  CHECK(refused(two + two, "").find("another camera has the same number") != std::string::npos);
  CHECK(refused(two, image + "9 a.png\n\n").find("no camera with the number") != std::string::npos);
  CHECK(refused(two, "1 2 0 0 0 0 0 4 1 a.png\n\n").find("length of the quaternion is 2") !=
        std::string::npos);
  CHECK(refused(two, "1 1 0 nan 0 0 0 4 1 a.png\n\n").find("'nan' is not a number") !=
        std::string::npos);
  CHECK(refused(two, image + "1 a.png\n\n" + image + "1 a.png\n\n")
            .find("two pictures have the name") != std::string::npos);
}

}  // namespace glassbox::views
