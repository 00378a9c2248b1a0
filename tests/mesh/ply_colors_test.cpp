// The colours of PLY files, whose range the format does not give.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/mesh/ply_builder.h"
#include "tests/support/catch.h"

#include <glassbox/images/srgb.h>

namespace glassbox::test {
namespace {

struct ColoredPly {
  std::vector<Rgba> colors;
  std::vector<std::string> warnings;
};

// A triangle whose three vertices have these values of red, as text; green and blue are 0.
ColoredPly with_red(const std::string& type, const std::vector<std::string>& red) {
  std::ostringstream file;
  file << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\n";
  for (const char* channel : {"red", "green", "blue"}) {
    file << "property " << type << ' ' << channel << '\n';
  }
  file << "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 3; ++i) {
    file << i << ' ' << i * i << " 0 " << red[std::size_t(i)] << " 0 0\n";
  }
  file << "3 0 1 2\n";
  const auto scene = load_ply_memory(file.str());
  INFO((scene ? "" : scene.error().message()));
  REQUIRE(scene);
  return {scene->meshes[0].colors, scene->warnings};
}

// The 8-bit codes of sRGB that were made from the numbers.
std::vector<int> codes_of(const std::string& type, const std::vector<std::string>& red) {
  std::vector<int> codes;
  for (const Rgba& color : with_red(type, red).colors) {
    for (int code = 0; code < 256; ++code) {
      if (decode_srgb(std::uint8_t(code)) == color.r) codes.push_back(code);
    }
    CHECK(color.g == 0);
  }
  return codes;
}

using Codes = std::vector<int>;
using Words = std::vector<std::string>;

TEST_CASE("PLY: colours have the range of their type where their numbers use it") {
  CHECK(codes_of("uchar", {"0", "1", "255"}) == Codes{0, 1, 255});
  CHECK(codes_of("uchar", {"0", "1", "2"}) == Codes{0, 1, 2});
  CHECK(codes_of("char", {"0", "127", "-5"}) == Codes{0, 255, 0});
  CHECK(codes_of("ushort", {"257", "65535", "0"}) == Codes{1, 255, 0});
  CHECK(codes_of("short", {"32767", "0", "256"}) == Codes{255, 0, 2});
  CHECK(codes_of("int", {"2147483647", "0", "8421504"}) == Codes{255, 0, 1});
  CHECK(codes_of("uint", {"4294967295", "0", "16843009"}) == Codes{255, 0, 1});
  CHECK(codes_of("float", {"0", "0.2", "1"}) == Codes{0, 51, 255});
  CHECK(codes_of("double", {"nan", "-1", "1.001"}) == Codes{0, 0, 255});
  for (const char* type : {"uchar", "char", "float"}) {
    CHECK(with_red(type, {"1", "0", "1"}).warnings.empty());
  }
  CHECK(with_red("uint", {"4294967295", "0", "1"}).warnings.empty());
  CHECK(with_red("int", {"0", "0", "0"}).warnings.empty());
}

TEST_CASE("PLY: wide numbers that fit into 0 to 255 or 65535 are read so, with a warning") {
  for (const char* type : {"short", "ushort", "int", "uint", "float", "double"}) {
    INFO(type);
    CHECK(codes_of(type, {"128", "64", "32"}) == Codes{128, 64, 32});
    CHECK(codes_of(type, {"255", "0", "2"}) == Codes{255, 0, 2});
    CHECK(with_red(type, {"128", "64", "32"}).warnings ==
          Words{"the colours of element 'vertex' are of the type " + std::string(type) +
                ", and none is above 128: they are read as 0 to 255"});
  }
  for (const char* type : {"int", "uint", "float", "double"}) {
    INFO(type);
    CHECK(codes_of(type, {"65535", "257", "514"}) == Codes{255, 1, 2});
    CHECK(with_red(type, {"65535", "0", "1"}).warnings ==
          Words{"the colours of element 'vertex' are of the type " + std::string(type) +
                ", and none is above 65535: they are read as 0 to 65535"});
  }
  CHECK(codes_of("float", {"inf", "100", "0"}) == Codes{255, 100, 0});
}

TEST_CASE("PLY: alpha follows the rule of its own type") {
  PlyBuilder b(PlyFormat::kAscii);
  b.element("vertex", 3).property("float", "x").property("float", "y").property("float", "z");
  for (const char* name : {"red", "green", "blue"}) b.property("int", name);
  b.property("float", "alpha").element("face", 1).list("uchar", "int", "vertex_indices");
  b.begin_data();
  for (int i = 0; i < 3; ++i) {
    b.floats({double(i), double(i * i), 0}).ints({200, 100, 0}).floats({0.5}).end_row();
  }
  b.uchars({3}).ints({0, 1, 2}).end_row();
  const auto scene = load_ply_memory(b.file());
  REQUIRE(scene);
  CHECK(scene->meshes[0].colors[0] == Rgba{decode_srgb(200), decode_srgb(100), 0, 0.5f});
  CHECK(scene->warnings.size() == 1);
}

}  // namespace
}  // namespace glassbox::test
