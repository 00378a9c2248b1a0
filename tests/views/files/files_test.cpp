// Text files of matches and cameras: valid ones are read and written, others are refused.
#include <tests/support/catch.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/skip.h"
#include "tests/views/two_view/random_rigs.h"
#include "views/files/camera_file.h"
#include "views/files/match_file.h"

namespace glassbox::views {
namespace {

std::string message_of(const auto& result) {
  REQUIRE_FALSE(result);
  return result.error().message();
}

TEST_CASE("matches are read with any separator, and written so that they are read again") {
  const auto read = parse_matches("1 2 3 4\n# a comment\n\n5,6;-7.5e1\t+8 # and one\r\n");
  REQUIRE(read);
  REQUIRE(read->size() == 2);
  CHECK((*read)[1].right == Vector2d(-75, 8));
  std::mt19937 random(50);
  const Matches matches = test::random_matches(random, test::random_rig(random), 20, 1);
  const auto again = parse_matches(matches_text(matches));
  REQUIRE(again);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    CHECK((*again)[i].left == matches[i].left);
    CHECK((*again)[i].right == matches[i].right);
  }
  CHECK(parse_matches("")->empty());
}

TEST_CASE("lines that are no matches are named") {
  CHECK(message_of(parse_matches("1 2 3 4\n1 2 3\n")) ==
        "line 2: a match needs 4 numbers, but there are 3; write x and y of the left picture, then "
        "of the right one");
  CHECK(message_of(parse_matches("x_left,y_left,x_right,y_right\n1 2 3 nan\n"))
            .starts_with("line 1: 'nan' is not a finite number"));
  CHECK(message_of(parse_matches("1 2 3 1e999\n")).starts_with("line 1: '1e999'"));
  CHECK(message_of(parse_matches("1 2 3 +-4\n")).starts_with("line 1: '+-4'"));
  CHECK(message_of(parse_matches("a 1 2 3 4")).find("after a word") != std::string::npos);
}

std::string sample_cameras(const std::string& rotation) {
  return "1\nleft.png 800 0 320 0 800 240 0 0 1 " + rotation + " 0.5 0 2\n";
}

TEST_CASE("cameras are read as they were written, and bad ones are refused") {
  std::mt19937 random(51);
  std::vector<NamedCamera> cameras;
  for (int i = 0; i < 5; ++i) {
    const RelativePose pose = test::random_rig(random).pose;
    cameras.push_back({"p" + std::to_string(i) + ".png",
                       {test::sample_intrinsic(), pose.rotation, pose.translation}});
  }
  const auto read = parse_cameras(cameras_text(cameras));
  REQUIRE(read);
  REQUIRE(read->size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK((*read)[i].picture == cameras[i].picture);
    CHECK(((*read)[i].camera.centre - cameras[i].camera.centre).norm() < 1e-14);
    CHECK(((*read)[i].camera.camera_from_world - cameras[i].camera.camera_from_world).norm() <
          1e-14);
  }
  CHECK(parse_cameras(sample_cameras("1 0 0 0 1 0 0 0 1")));
  CHECK(message_of(parse_cameras(sample_cameras("1 0 0 0 1 0 0 0 -1"))).find("mirror") !=
        std::string::npos);
  CHECK(message_of(parse_cameras(sample_cameras("1 0 0 0 1 0 0 0.1 1"))).find("not a rotation") !=
        std::string::npos);
  CHECK(message_of(parse_cameras("2\n")).find("announces 2 cameras, but there are 0") !=
        std::string::npos);
  CHECK(message_of(parse_cameras("1\na 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 1 0 0 0"))
            .find("matrix K is wrong") != std::string::npos);
  CHECK_FALSE(parse_cameras(""));
}

TEST_CASE("the temple's cameras project a point of it into all of its pictures") {
  const std::filesystem::path folder =
      std::filesystem::path(GLASSBOX_ASSETS_DIR) / "stereo/multiview/templeSparseRing";
  std::ifstream file(folder / "templeSR_par.txt");
  if (!file) SKIP_TEST("no multi-view pictures under " << folder);
  std::stringstream text;
  text << file.rdbuf();
  const auto cameras = parse_cameras(text.str());
  REQUIRE(cameras);
  CHECK(cameras->size() == 16);
  for (const NamedCamera& each : *cameras) {
    // The corners of the tight bounding box that README.txt gives.
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d pixel =
          project(each.camera, {corner & 1 ? -0.073568 : 0.028855, corner & 2 ? 0.021728 : 0.181892,
                                corner & 4 ? -0.012445 : 0.062736});
      CHECK(pixel.z() > 0);
      CHECK((pixel.x() > 0 && pixel.x() < 640 && pixel.y() > 0 && pixel.y() < 480));
    }
  }
}

}  // namespace
}  // namespace glassbox::views
