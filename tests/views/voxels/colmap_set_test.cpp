// Sets of pictures whose cameras are a model of COLMAP: where its files may be, and what the sizes
// of the pictures have to be.
#include <tests/support/catch.h>

#include <filesystem>
#include <fstream>

#include <Eigen/Geometry>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

#include "tests/images/temporary_directory.h"
#include "tests/views/files/colmap_builder.h"
#include "tests/views/voxels/rig.h"

namespace glassbox::views {
namespace {

namespace fs = std::filesystem;
using glassbox::test::TemporaryDirectory;

constexpr int kSide = 32;

std::string why_refused(const Result<PictureSet>& set) {
  REQUIRE_FALSE(set);
  return set.error().message();
}

PictureSet ring() {
  RingOptions options;
  options.views = 3;
  options.width = options.height = kSide;
  return test::ring_of(test::speckled_sphere(8, 1), options);
}

// The cameras of a ring as a model of COLMAP with one lens.
test::Model model_of(const PictureSet& set) {
  const Matrix3d& k = set.pictures[0].camera.intrinsic;
  test::Model model;
  model.lenses = {{1, 1, kSide, kSide, {k(0, 0), k(1, 1), k(0, 2), k(1, 2)}}};
  for (const CalibratedPicture& picture : set.pictures) {
    const Eigen::Quaterniond turn(picture.camera.camera_from_world);
    const Vector3d shift = -picture.camera.camera_from_world * picture.camera.centre;
    model.pictures.push_back({picture.name,
                              {turn.w(), turn.x(), turn.y(), turn.z()},
                              {shift.x(), shift.y(), shift.z()}});
  }
  return model;
}

void write_files(const fs::path& folder, const test::ModelFiles& files,
                 const std::string& extension) {
  fs::create_directories(folder);
  std::ofstream(folder / ("cameras" + extension), std::ios::binary) << files.cameras;
  std::ofstream(folder / ("images" + extension), std::ios::binary) << files.images;
}

void write_pictures(const fs::path& root, const PictureSet& set) {
  fs::create_directories(root / "images");
  fs::create_directories(root / "masks");
  for (const CalibratedPicture& picture : set.pictures) {
    REQUIRE(write_image((root / "images" / picture.name).string(), picture.color));
    Image<Rgba8> mask(kSide, kSide);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
      const std::uint8_t value = picture.matte.pixels[i];
      mask.pixels[i] = {value, value, value, 255};
    }
    REQUIRE(write_image((root / "masks" / picture.name).string(), mask));
  }
  std::ofstream(root / "box.txt") << "-1 -1 -1\n1 1 1\n";
}

void check_same(const Result<PictureSet>& read, const PictureSet& set) {
  INFO((read ? "" : read.error().message()));
  REQUIRE(read);
  REQUIRE(read->pictures.size() == set.pictures.size());
  CHECK(read->box);
  for (std::size_t i = 0; i < set.pictures.size(); ++i) {
    const CalibratedPicture &again = read->pictures[i], &picture = set.pictures[i];
    CHECK(again.name == picture.name);
    CHECK(again.color == picture.color);
    CHECK(again.matte == picture.matte);
    // A quaternion and back is a few roundings.
    CHECK((again.camera.centre - picture.camera.centre).norm() < 1e-12);
  }
}

}  // namespace

TEST_CASE("a model of COLMAP is found where COLMAP leaves it, with the pictures beside it") {
  const PictureSet set = ring();
  const test::Model model = model_of(set);
  for (const std::string extension : {".bin", ".txt"}) {
    const test::ModelFiles files = extension == ".bin" ? binary_of(model) : text_of(model);
    for (const std::string place : {"", "sparse", "sparse/0"}) {
      CAPTURE(extension, place);
      const TemporaryDirectory directory;
      const fs::path root = directory.path() / "project", folder = root / place;
      write_files(folder, files, extension);
      write_pictures(root, set);
      check_same(read_picture_set(root.string(), {}), set);
      check_same(read_picture_set(folder.string(), {}), set);
      if (place == "sparse/0") check_same(read_picture_set((root / "sparse").string(), {}), set);
      check_same(read_picture_set((folder / ("images" + extension)).string(), {}), set);
      check_same(read_picture_set((folder / ("points3D" + extension)).string(), {}), set);
      const fs::path before = fs::current_path();
      fs::current_path(folder);
      const auto here = read_picture_set("cameras" + extension, {});
      fs::current_path(before);
      check_same(here, set);
    }
  }
}

TEST_CASE("of text and binary in one folder, binary is read; of several models, the first") {
  const PictureSet set = ring();
  const TemporaryDirectory directory;
  const fs::path root = directory.path();
  write_pictures(root, set);
  write_files(root / "sparse/0", binary_of(model_of(set)), ".bin");
  write_files(root / "sparse/0", {"broken", "broken"}, ".txt");
  auto read = read_picture_set(root.string(), {});
  check_same(read, set);
  CHECK(read->warnings.empty());
  CHECK_FALSE(read_picture_set((root / "sparse/0/cameras.txt").string(), {}));
  fs::create_directories(root / "sparse/1");
  read = read_picture_set(root.string(), {});
  check_same(read, set);
  REQUIRE(read->warnings.size() == 1);
  CHECK(read->warnings[0] == "there are several models of COLMAP; the one in the folder 0 is read");
}

TEST_CASE("pictures of another size than their lens are refused") {
  const PictureSet set = ring();
  for (const auto& [width, height] : {std::pair(2 * kSide, 2 * kSide), std::pair(kSide, kSide + 1),
                                      std::pair(kSide - 1, kSide)}) {
    const TemporaryDirectory directory;
    test::Model model = model_of(set);
    model.lenses[0].width = std::uint64_t(width);
    model.lenses[0].height = std::uint64_t(height);
    write_files(directory.path(), text_of(model), ".txt");
    write_pictures(directory.path(), set);
    const std::string why = why_refused(read_picture_set(directory.path().string(), {}));
    CAPTURE(why);
    CHECK(why.find(fmt::format("is 32 x 32, but its camera is one for {} x {} pixels", width,
                               height)) != std::string::npos);
  }
}

TEST_CASE("a quaternion that was made unit is a warning of the set") {
  const PictureSet set = ring();
  const TemporaryDirectory directory;
  test::Model model = model_of(set);
  for (double& number : model.pictures[1].turn) number *= 1.01;
  write_files(directory.path(), binary_of(model), ".bin");
  write_pictures(directory.path(), set);
  const auto read = read_picture_set(directory.path().string(), {});
  check_same(read, set);
  REQUIRE(read->warnings.size() == 1);
  CHECK(read->warnings[0].find("images.bin, picture 2: the quaternion had the length 1.01") == 0);
}

TEST_CASE("the pixels of a JPEG of COLMAP are those that are stored") {
  const TemporaryDirectory directory;
  // 9 x 7 pixels as stored, with an orientation that turns them by 90 degrees.
  fs::copy(GLASSBOX_SOURCE_DIR "/tests/fuzz/corpus/stored/turned.jpg",
           directory.file("turned.jpg"));
  write_files(directory.path(), test::text_of({{{1, 1, 9, 7, {9, 9, 4.5, 3.5}}}, {{"turned.jpg"}}}),
              ".txt");
  const auto read = read_picture_set(directory.path().string(), {});
  INFO((read ? "" : read.error().message()));
  REQUIRE(read);
  CHECK(read->pictures[0].color.width == 9);
  CHECK(read->pictures[0].color ==
        read_image(GLASSBOX_SOURCE_DIR "/tests/fuzz/corpus/stored/rgb-subsampled.jpg").value());
}

}  // namespace glassbox::views
