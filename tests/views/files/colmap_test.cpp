// COLMAP's cameras, as text and in binary: read, and refused where they are broken.
#include <tests/support/catch.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/views/files/colmap_builder.h"
#include "tests/views/two_view/random_rigs.h"
#include "views/files/colmap_file.h"

namespace glassbox::views {
namespace {

using test::Model;
using test::ModelFiles;

Result<ColmapModel> parse_text(const ModelFiles& files) {
  return parse_colmap(files.cameras, files.images);
}
Result<ColmapModel> parse_binary(const ModelFiles& files) {
  return parse_colmap_binary(std::as_bytes(std::span(files.cameras)),
                             std::as_bytes(std::span(files.images)));
}

std::string why_refused(const Result<ColmapModel>& model) {
  REQUIRE_FALSE(model);
  CHECK_FALSE(model.error().remedy.empty());
  return model.error().message();
}

// Refused in either form, with these words.
void check_refused(const Model& model, const std::string& words) {
  for (const auto& read : {parse_text(text_of(model)), parse_binary(binary_of(model))}) {
    CHECK(why_refused(read).find(words) != std::string::npos);
  }
}

// A model whose numbers come back from decimal text with all their digits.
Model random_model(std::mt19937& random) {
  Model model;
  model.lenses = {{7, 0, 640, 480, {500.25, 320.5, 240.125}},
                  {-2, 1, 64, 48, {50.1, 51.3, 32, 24}},
                  {3, 6, 8, 9, {5, 6, 4, 4.5, 0, 0, 0, 0, 0, 0, 0, 0}}};
  for (int i = 0; i < 6; ++i) {
    const RelativePose pose = test::random_rig(random).pose;
    const Eigen::Quaterniond turn(pose.rotation);
    const Vector3d& shift = pose.translation;
    model.pictures.push_back({"p" + std::to_string(5 - i) + ".png",
                              {turn.w(), turn.x(), turn.y(), turn.z()},
                              {shift.x(), shift.y(), shift.z()},
                              model.lenses[std::size_t(i) % 3].id,
                              std::size_t(i)});
  }
  return model;
}

}  // namespace

TEST_CASE("COLMAP's text files give the cameras that they describe") {
  const auto read = parse_colmap(
      "# comment\n1 PINHOLE 640 480 500 510 320 240\n2 SIMPLE_PINHOLE 64 48 50 32 24\n",
      "# two lines each\n"
      "7 0.7071067811865476 0 0.7071067811865476 0 1 2 3 1 b.png\n"
      "10 10 -1 20 20 3\n"
      "2 1 0 0 0 0 0 4 2 a.png\n\n");
  REQUIRE(read);
  REQUIRE(read->cameras.size() == 2);
  CHECK(read->warnings.empty());
  CHECK(read->cameras[0].picture == "a.png");
  CHECK(read->cameras[0].size->width == 64);
  CHECK(read->cameras[1].size->height == 480);
  CHECK(read->cameras[0].camera.intrinsic(0, 0) == 50);
  CHECK(read->cameras[0].camera.centre == Vector3d(0, 0, -4));
  // A quarter turn about y turns the world's z into the camera's x.
  const PinholeCamera& turned = read->cameras[1].camera;
  CHECK(turned.intrinsic(1, 1) == 510);
  CHECK((turned.camera_from_world * Vector3d::UnitZ() - Vector3d::UnitX()).norm() < 1e-15);
  CHECK((turned.camera_from_world * turned.centre + Vector3d(1, 2, 3)).norm() < 1e-14);
}

TEST_CASE("a model in binary is the model in text") {
  std::mt19937 random(241);
  for (int round = 0; round < 30; ++round) {
    const Model model = random_model(random);
    const auto text = parse_text(text_of(model)), binary = parse_binary(binary_of(model));
    REQUIRE(text);
    REQUIRE(binary);
    REQUIRE(text->cameras.size() == model.pictures.size());
    REQUIRE(binary->cameras.size() == model.pictures.size());
    for (std::size_t i = 0; i < text->cameras.size(); ++i) {
      const NamedCamera &a = text->cameras[i], &b = binary->cameras[i];
      REQUIRE(a.picture == "p" + std::to_string(i) + ".png");
      REQUIRE(b.picture == a.picture);
      REQUIRE(b.camera.intrinsic == a.camera.intrinsic);
      REQUIRE(b.camera.camera_from_world == a.camera.camera_from_world);
      REQUIRE(b.camera.centre == a.camera.centre);
      REQUIRE(b.size->width == a.size->width);
      REQUIRE(b.size->height == a.size->height);
    }
  }
}

TEST_CASE("a lens that cannot be used refuses the model only where a picture has it") {
  const std::vector<test::ModelLens> useless{
      {9, 2, 64, 48, {50, 32, 24, 0.1}},                                    // distortion
      {9, 5, 64, 48, {50, 50, 32, 24, 0, 0, 0, 0}},                         // a fisheye
      {9, 1, 64, 48, {0, 50, 32, 24}},                                      // no focal length
      {9, 1, 0, 48, {50, 50, 32, 24}},                                      // no size
      {9, 0, 64, 48, {std::numeric_limits<double>::quiet_NaN(), 32, 24}}};  // no number
  const char* words[] = {"the camera has distortion", "'OPENCV_FISHEYE' is not a pinhole model",
                         "a focal length is not positive", "cannot have 0 x 48 pixels", "number"};
  for (std::size_t i = 0; i < useless.size(); ++i) {
    Model model{{{}, useless[i]}, {{"a.png"}}};
    CHECK(parse_text(text_of(model)));
    CHECK(parse_binary(binary_of(model)));
    model.pictures[0].lens = 9;
    check_refused(model, words[i]);
  }
  // Text has kinds that binary has not.
  const std::string image = "1 1 0 0 0 0 0 4 5 a.png\n\n";
  CHECK(why_refused(parse_colmap("5 BALLOON 64 48 50 32 24\n", image))
            .find("'BALLOON' is not a pinhole model") != std::string::npos);
  CHECK(parse_colmap("4 BALLOON\n5 PINHOLE 64 48 50 50 32 24\n", image));
}

TEST_CASE("quaternions of nearly unit length are made unit, with a warning") {
  for (const double length : {0.91, 0.998, 1.0, 1.0005, 1.002, 1.09}) {
    CAPTURE(length);
    const Model model{{{}}, {{"a.png", {0.6 * length, 0, 0.8 * length, 0}}, {"b.png"}}};
    for (const auto& read : {parse_text(text_of(model)), parse_binary(binary_of(model))}) {
      REQUIRE(read);
      const Matrix3d& turn = read->cameras[0].camera.camera_from_world;
      CHECK((turn.transpose() * turn - Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-15);
      CHECK(std::abs(turn(0, 2) - 2 * 0.6 * 0.8) < 1e-15);
      REQUIRE(read->warnings.size() == (std::abs(length - 1) > 1e-3 ? 1 : 0));
      if (!read->warnings.empty()) {
        CHECK(read->warnings[0].find(fmt::format("had the length {:.6g} and", length)) !=
              std::string::npos);
      }
    }
  }
  const Model three{{{}}, {{"a", {1.01, 0, 0, 0}}, {"b", {0.99, 0, 0, 0}}, {"c", {1.02, 0, 0, 0}}}};
  CHECK(parse_text(text_of(three))->warnings ==
        std::vector<std::string>{"images.txt, line 2: the quaternion had the length 1.01 and was "
                                 "made one of length 1, as did those of 2 other pictures"});
  for (const double length : {0.0, 0.89, 1.11, 2.0}) {
    check_refused({{{}}, {{"a.png", {length, 0, 0, 0}}}},
                  fmt::format("the length of the quaternion is {:.6g}, but", length));
  }
}

TEST_CASE("models that contradict themselves are refused") {
  check_refused({{{}, {}}, {}}, "another camera has the same number");
  check_refused({{{}}, {{"a.png", {1, 0, 0, 0}, {0, 0, 4}, 9}}}, "no camera with the number 9");
  check_refused({{{}}, {{"a.png"}, {"a.png"}}}, "two pictures have the name 'a.png'");
  const std::string image = "1 1 0 0 0 0 0 4 5 a.png\n\n";
  CHECK(why_refused(parse_colmap("5 PINHOLE 64 48 50\n", image)).find("has 5 of the 8 words") !=
        std::string::npos);
  CHECK(why_refused(parse_colmap("x PINHOLE 64 48 50 50 32 24\n", image))
            .find("'x' is not the number of a camera") != std::string::npos);
  CHECK(why_refused(parse_colmap("5 PINHOLE 64 48 50 50 32 24\n", "1 1 0 nan 0 0 0 4 5 a.png\n\n"))
            .find("'nan' is not a number") != std::string::npos);
}

TEST_CASE("a binary model that is cut off anywhere, or longer than it says, is refused") {
  std::mt19937 random(251);
  const ModelFiles whole = binary_of(random_model(random));
  REQUIRE(parse_binary(whole));
  for (std::size_t size = 0; size < whole.cameras.size(); ++size) {
    CAPTURE(size);
    why_refused(parse_binary({whole.cameras.substr(0, size), whole.images}));
  }
  for (std::size_t size = 0; size < whole.images.size(); ++size) {
    CAPTURE(size);
    why_refused(parse_binary({whole.cameras, whole.images.substr(0, size)}));
  }
  CHECK(why_refused(parse_binary({whole.cameras + "x", whole.images})).find("1 byte stand") !=
        std::string::npos);
  why_refused(parse_binary({whole.cameras, whole.images + std::string(64, '\0')}));
}

TEST_CASE("huge counts in a binary model are refused at once") {
  std::mt19937 random(257);
  const Model model = random_model(random);
  const ModelFiles whole = binary_of(model);
  const auto with = [](std::string bytes, std::size_t at, std::uint64_t value, int size) {
    std::string number;
    test::put(number, value, size);
    return bytes.replace(at, number.size(), number);
  };
  // Where the first picture has its number of points: behind the count, its number, its pose, its
  // lens and its name.
  const std::size_t points_at = 8 + 4 + 7 * 8 + 4 + model.pictures[0].name.size() + 1;
  for (const std::uint64_t count :
       {std::uint64_t(1) << 40, std::uint64_t(1) << 61, ~std::uint64_t(0),
        ~std::uint64_t(0) / 24 + 2}) {  // 24 times the last is small again in 64 bits
    CAPTURE(count);
    why_refused(parse_binary({with(whole.cameras, 0, count, 8), whole.images}));
    why_refused(parse_binary({whole.cameras, with(whole.images, 0, count, 8)}));
    why_refused(parse_binary({whole.cameras, with(whole.images, points_at, count, 8)}));
    // A width that no picture has; the lens is the first picture's.
    why_refused(parse_binary({with(whole.cameras, 16, count, 8), whole.images}));
  }
  for (const std::uint32_t kind : {12u, 99u, 0x7fffffffu, 0xffffffffu}) {
    CHECK(why_refused(parse_binary({with(whole.cameras, 12, kind, 4), whole.images}))
              .find("whose parameters are not known") != std::string::npos);
  }
}

TEST_CASE("a binary model with any bytes changed is read or refused, never worse") {
  std::mt19937 random(263);
  const ModelFiles whole = binary_of(random_model(random));
  std::uniform_int_distribution<int> byte(0, 255);
  for (int round = 0; round < 4000; ++round) {
    ModelFiles changed = whole;
    std::string& bytes = round % 2 == 0 ? changed.cameras : changed.images;
    std::uniform_int_distribution<std::size_t> place(0, bytes.size() - 1);
    for (int i = 0; i < 1 + round % 3; ++i) {
      const std::size_t at = place(random);
      bytes[at] = char(byte(random));
    }
    const auto read = parse_binary(changed);
    if (read) {
      for (const NamedCamera& camera : read->cameras) {
        REQUIRE(camera.camera.camera_from_world.allFinite());
        REQUIRE(camera.camera.centre.allFinite());
      }
    } else {
      why_refused(read);
    }
  }
}

}  // namespace glassbox::views
