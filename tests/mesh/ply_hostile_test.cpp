// PLY files with wrong numbers: each gives an error that names the place, and none crashes the
// loader or makes it allocate memory out of proportion.
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tests/mesh/ply_builder.h"
#include "tests/support/catch.h"

#include <glassbox/base/random.h>
#include <glassbox/mesh/formats/load_memory.h>

namespace glassbox::test {
namespace {

std::string error_of_ply(const std::string& file, const LoadLimits& limits = {}) {
  const auto scene = load_ply_memory(file, limits);
  return scene ? std::string() : scene.error().message();
}

bool message_mentions(const std::string& text, const std::string& part) {
  INFO(text);
  return text.find(part) != std::string::npos;
}

// The triangle in text format, with a part of it replaced.
std::string with(const std::string& part, const std::string& replacement) {
  std::string file = ply_triangle(PlyFormat::kAscii).file();
  const std::size_t at = file.find(part);
  REQUIRE(at != std::string::npos);
  return file.replace(at, part.size(), replacement);
}

TEST_CASE("PLY: a file cut off at any byte is an error, in each format") {
  for (const PlyFormat format :
       {PlyFormat::kAscii, PlyFormat::kLittleEndian, PlyFormat::kBigEndian}) {
    const std::string file = ply_triangle(format).file();
    REQUIRE(error_of_ply(file) == "");
    // A text file is complete without the blank and the line end after its last number.
    const std::size_t needed = file.size() - (format == PlyFormat::kAscii ? 2 : 0);
    for (std::size_t length = 0; length < needed; ++length) {
      CAPTURE(length);
      CHECK_FALSE(load_ply_memory(file.substr(0, length)));
    }
  }
}

TEST_CASE("PLY: changed bytes are an error or a scene whose numbers are finite and in range") {
  Random random(20261122);
  for (int run = 0; run < 3000; ++run) {
    const PlyFormat format = PlyFormat(run % 3);
    std::string file = ply_triangle(format).file();
    const int changes = int(random.integer(1, 4));
    for (int i = 0; i < changes; ++i) {
      file[std::size_t(random.integer(0, std::int64_t(file.size()) - 1))] =
          char(random.integer(0, 255));
    }
    const auto scene = load_ply_memory(file);
    if (!scene) continue;
    for (const Mesh& mesh : scene->meshes) {
      for (const Corner& corner : mesh.corners) CHECK(corner.position < mesh.positions.size());
      for (const auto& p : mesh.positions) CHECK(std::isfinite(p.x + p.y + p.z));
    }
  }
}

TEST_CASE("PLY: counts are held against the bytes that exist before anything is allocated") {
  for (const char* count : {"1000000", "4294967294"}) {
    CHECK(message_mentions(error_of_ply(with("vertex 3", std::string("vertex ") + count)),
                           "element 'vertex': the "));
    CHECK(message_mentions(error_of_ply(with("face 1", std::string("face ") + count)),
                           "element 'face': the "));
  }
  for (const char* count : {"4294967295", "99999999999"}) {
    CHECK(message_mentions(error_of_ply(with("vertex 3", std::string("vertex ") + count)),
                           "but at most 4294967294 are read"));
  }
  CHECK(message_mentions(error_of_ply(with("vertex 3", "vertex -3")), "needs a name and a count"));
  CHECK(message_mentions(error_of_ply(with("vertex 3", "vertex 3e0")), "needs a name and a count"));
  // Lists that claim more entries than there are, and a signed count that is negative.
  CHECK(message_mentions(error_of_ply(with("3 0 1 2", "200 0 1 2")), "face 0 (line 13): its list"));
  std::string negative = with("list uchar", "list char");
  negative.replace(negative.find("3 0 1 2"), 7, "-1 0 1 2");
  CHECK(message_mentions(error_of_ply(negative), "has -1 entries"));
  PlyBuilder big(PlyFormat::kBigEndian);
  big.element("vertex", 1).property("float", "x").property("float", "y").property("float", "z");
  big.element("face", 1).list("uint", "uint", "vertex_indices");
  big.begin_data().floats({0, 0, 0}).ints({-1}).ints({0, 0, 0});
  CHECK(message_mentions(error_of_ply(big.file()),
                         "has 4294967295 entries, which the file does not hold"));
  // Elements without properties take no bytes and no memory.
  const std::string nothing = with("element face", "element void 4000000000\nelement face");
  CHECK(error_of_ply(nothing) == "");
}

TEST_CASE("PLY: a position that is no finite number is named by its vertex") {
  CHECK(message_mentions(error_of_ply(with("1 1 0", "1 nan 0")),
                         "vertex 1 (line 11): its y is not a number (NaN)"));
  CHECK(message_mentions(error_of_ply(with("1 1 0", "-inf 1 0")),
                         "vertex 1 (line 11): its x is infinite"));
  CHECK(message_mentions(error_of_ply(with("1 1 0", "1 1 1e39")),
                         "vertex 1 (line 11): its z is beyond what a float can hold"));
  PlyBuilder b(PlyFormat::kBigEndian);
  b.element("vertex", 2).property("double", "x").property("double", "y").property("double", "z");
  b.element("face", 1).list("uchar", "int", "vertex_indices");
  b.begin_data().doubles({0, 0, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0});
  b.uchars({3}).ints({0, 1, 1});
  CHECK(message_mentions(error_of_ply(b.file()), "vertex 1 (byte "));
}

TEST_CASE("PLY: a vertex that no face uses may have any numbers, which is a warning") {
  for (const PlyFormat format :
       {PlyFormat::kAscii, PlyFormat::kLittleEndian, PlyFormat::kBigEndian}) {
    PlyBuilder b(format);
    b.element("vertex", 5).property("double", "x").property("double", "y").property("double", "z");
    b.element("face", 1).list("uchar", "int", "vertex_indices");
    b.begin_data();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    b.doubles({0, 0, 0}).end_row();
    b.doubles({nan, 0, 0}).end_row();
    b.doubles({1, 0, 0}).end_row();
    b.doubles({0, -1e300, nan}).end_row();
    b.doubles({0, 1, 0}).end_row();
    const auto scene = load_ply_memory(b.uchars({3}).ints({0, 2, 4}).end_row().file());
    INFO((scene ? "" : scene.error().message()));
    REQUIRE(scene);
    CHECK(scene->warnings ==
          std::vector<std::string>{
              "2 unused vertices do not have three finite numbers (first: vertex 1)"});
    for (const auto& p : scene->meshes[0].positions) CHECK(std::isfinite(p.x + p.y + p.z));
  }
}

TEST_CASE("PLY: indices out of range are named by their face") {
  CHECK(message_mentions(error_of_ply(with("3 0 1 2", "3 0 1 3")),
                         "face 0 (line 13): names vertex 3, but the file has only 3"));
  CHECK(message_mentions(error_of_ply(with("3 0 1 2", "3 0 -1 2")),
                         "names vertex -1, but the file has only 3"));
  CHECK(message_mentions(error_of_ply(with("list uchar int", "list uchar float")),
                         "no list 'vertex_indices' of integers"));
  CHECK(message_mentions(error_of_ply(with("3 0 1 2", "3 0 1 x")),
                         "'x' is not a number of the type"));
  CHECK(message_mentions(error_of_ply(with("3 0 1 2", "300 0 1 2")),
                         "'300' is not a number of the type"));
}

TEST_CASE("PLY: a point cloud and what has nothing to draw are refused with what they are") {
  CHECK(
      message_mentions(error_of_ply(with("face 1", "face 0")),
                       "has 3 vertices and no faces: a point cloud, which has no surface to draw"));
  const std::string cloud =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n0 0 0\n";
  CHECK(message_mentions(error_of_ply(cloud), "a point cloud"));
  CHECK(message_mentions(error_of_ply(with("element face 1", "element tristrips 0")),
                         "a point cloud"));
  CHECK(message_mentions(error_of_ply(with("3 0 1 2", "2 0 1")),
                         "no face or strip has three corners or more"));
  CHECK(message_mentions(error_of_ply(with("property float z", "property float w")),
                         "no numbers x, y and z"));
}

TEST_CASE("PLY: a byte order mark before the magic and blanks behind it are passed over") {
  for (const PlyFormat format :
       {PlyFormat::kAscii, PlyFormat::kLittleEndian, PlyFormat::kBigEndian}) {
    const std::string rest = ply_triangle(format).file().substr(3);
    for (const char* magic : {"\xef\xbb\xbfply", "ply ", "ply \t ", "\xef\xbb\xbfply "}) {
      const std::string file = magic + rest;
      CHECK(error_of_ply(file) == "");
      CHECK(format_of(std::as_bytes(std::span(file))) == SceneFormat::kPly);
    }
  }
  CHECK(message_mentions(error_of_ply(with("ply\n", "ply x\n")), "line 1: is not 'ply'"));
  CHECK(message_mentions(error_of_ply(std::string("\xff\xfep\0l\0y\0\n\0", 10)),
                         "line 1: is text in UTF-16"));
}

TEST_CASE("PLY: headers that are not right are refused by their line") {
  CHECK(message_mentions(error_of_ply(""), "line 1: is not 'ply'"));
  CHECK(message_mentions(error_of_ply("plywood\n"), "line 1: is not 'ply'"));
  CHECK(message_mentions(error_of_ply(with("ascii", "text")),
                         "line 2: has the unknown format 'text'"));
  CHECK(message_mentions(error_of_ply(with("1.0", "2.0")), "line 2: has version '2.0'"));
  CHECK(message_mentions(error_of_ply(with("format ascii 1.0\n", "")), "has no 'format'"));
  CHECK(message_mentions(error_of_ply(with("element vertex 3\n", "")), "before the first element"));
  CHECK(message_mentions(error_of_ply(with("property float x", "property real x")),
                         "unknown type 'real'"));
  CHECK(
      message_mentions(error_of_ply(with("property float y", "property float x")), "occurs twice"));
  CHECK(message_mentions(error_of_ply(with("element face", "element vertex")), "occurs twice"));
  CHECK(message_mentions(error_of_ply(with("list uchar", "list float")), "not an integer"));
  CHECK(message_mentions(error_of_ply(with("property float z\n", "property float z\nmaterial 3\n")),
                         "unknown word 'material'"));
  CHECK(message_mentions(error_of_ply("ply\nformat ascii 1.0\nelement vertex 3\n"),
                         "no 'end_header'"));
  std::string many = "ply\nformat ascii 1.0\nelement vertex 3\n";
  for (int i = 0; i < 300; ++i) many += "property float p" + std::to_string(i) + "\n";
  CHECK(message_mentions(error_of_ply(many + "end_header\n"), "more than 256 properties"));
}

TEST_CASE("PLY: limits are kept") {
  LoadLimits limits;
  limits.max_corners = 2;
  CHECK(message_mentions(error_of_ply(ply_triangle(PlyFormat::kAscii).file(), limits),
                         "more than 2 corners"));
  limits = {};
  limits.max_file_bytes = 50;
  CHECK(message_mentions(error_of_ply(ply_triangle(PlyFormat::kAscii).file(), limits),
                         "more than 50 bytes"));
}

}  // namespace
}  // namespace glassbox::test
