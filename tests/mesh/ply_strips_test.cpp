// Triangle strips of PLY files, as Stanford's scans have them.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include "tests/mesh/ply_builder.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using CornerIndices = std::array<std::uint32_t, 3>;

std::string strip_file(PlyFormat format, int vertices, const std::vector<int>& strip) {
  PlyBuilder b(format);
  b.element("vertex", std::uint64_t(vertices));
  b.property("float", "x").property("float", "y").property("float", "z");
  b.element("tristrips", 1).list("int", "int", "vertex_indices").begin_data();
  for (int i = 0; i < vertices; ++i) b.floats({double(i), double(i % 2), 0}).end_row();
  b.ints({int(strip.size())}).ints(strip).end_row();
  return b.file();
}

std::vector<CornerIndices> faces_of_strip(const std::string& file) {
  const auto scene = load_ply_memory(file);
  INFO((scene ? "" : scene.error().message()));
  REQUIRE(scene);
  CHECK(scene->warnings.empty());
  std::vector<CornerIndices> faces;
  const Mesh& mesh = scene->meshes[0];
  for (const Face& face : mesh.faces) {
    REQUIRE(face.count == 3);
    CornerIndices corners{};
    for (std::uint32_t i = 0; i < 3; ++i) corners[i] = mesh.corners[face.first + i].position;
    faces.push_back(corners);
  }
  return faces;
}

TEST_CASE("PLY: a strip draws its triangles with one winding, in each format") {
  for (const PlyFormat format :
       {PlyFormat::kAscii, PlyFormat::kLittleEndian, PlyFormat::kBigEndian}) {
    CHECK(faces_of_strip(strip_file(format, 5, {0, 1, 2, 3, 4})) ==
          std::vector<CornerIndices>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
  }
}

TEST_CASE("PLY: -1 begins a new strip with its own first triangle") {
  CHECK(faces_of_strip(
            strip_file(PlyFormat::kAscii, 6, {-1, 0, 1, 2, -1, 3, 4, -1, -1, 5, 4, 3, 2, -1})) ==
        std::vector<CornerIndices>{{0, 1, 2}, {5, 4, 3}, {3, 4, 2}});
}

TEST_CASE("PLY: a vertex that a strip names twice only leads on") {
  CHECK(faces_of_strip(strip_file(PlyFormat::kAscii, 6, {0, 1, 2, 2, 3, 3, 4, 5})) ==
        std::vector<CornerIndices>{{0, 1, 2}, {4, 3, 5}});
}

TEST_CASE("PLY: random strips draw what one strip after the other would") {
  Random random(31);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<int> joined;
    std::vector<CornerIndices> expected;
    for (std::int64_t strips = random.integer(1, 4); strips > 0; --strips) {
      std::vector<std::uint32_t> strip;
      for (std::int64_t i = random.integer(0, 7); i > 0; --i) {
        strip.push_back(std::uint32_t(random.integer(0, 7)));
      }
      for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
        CornerIndices t{strip[i], strip[i + 1], strip[i + 2]};
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        if (i % 2 == 1) std::swap(t[0], t[1]);
        expected.push_back(t);
      }
      joined.insert(joined.end(), strip.begin(), strip.end());
      joined.push_back(-1);
    }
    if (expected.empty()) continue;
    CAPTURE(trial, joined);
    CHECK(faces_of_strip(strip_file(PlyFormat::kBigEndian, 8, joined)) == expected);
  }
}

TEST_CASE("PLY: what is wrong with a strip is named") {
  const auto refusal = [](const std::vector<int>& strip) {
    const auto scene = load_ply_memory(strip_file(PlyFormat::kAscii, 3, strip));
    return scene ? std::string() : scene.error().message();
  };
  CHECK(refusal({0, 1, 3}).find("strip 0 (line 13): names vertex 3, but the file has only 3") !=
        std::string::npos);
  CHECK(refusal({0, 1, -2}).find("names vertex -2") != std::string::npos);
  CHECK(refusal({0, 1, -1, 2}).find("no face or strip has three corners") != std::string::npos);
}

}  // namespace
}  // namespace glassbox::test
