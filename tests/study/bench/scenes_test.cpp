// The numbers that docs/benchmark.md states about the scenes.
#include <tests/support/catch.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glassbox/base/rounding.h>
#include <glassbox/render/stereo/render_pair.h>

#include <study/bench/glassbox_peer.h>
#include "study/scenes/scenes.h"
#include "study/scenes/vertex_arrays.h"

namespace glassbox::study {
namespace {

BenchScene scene_named(std::string_view name, int width = 1920, int height = 1080) {
  auto scene = make_bench_scene(name, width, height);
  REQUIRE(scene);
  return std::move(*scene);
}

VertexArrays arrays_of(const Mesh& mesh) {
  Scene scene;
  scene.meshes.push_back(mesh);
  scene.materials.emplace_back();
  const PreparedScene prepared = prepare_scene(scene, Transfer::kNone);
  return vertex_arrays(scene.meshes[0], prepared.meshes[0], true);
}

using Indices = std::array<std::uint32_t, 3>;

Indices triangle(const VertexArrays& arrays, std::size_t i) {
  return {arrays.indices[3 * i], arrays.indices[3 * i + 1], arrays.indices[3 * i + 2]};
}

TEST_CASE("every scene has the triangles that the table says") {
  const std::vector<std::pair<std::string_view, std::size_t>> table = {
      {"S1", 998000}, {"S1b", 998000}, {"S2", 70224}, {"S3", 12},    {"S4bf", 128},
      {"S4fb", 128},  {"S5", 998000},  {"S6", 70224}, {"S7", 998000}};
  for (const auto& [name, triangles] : table) {
    INFO(name);
    const BenchScene bench = scene_named(name);
    CHECK(bench.scene.meshes.at(0).faces.size() == triangles);
    CHECK(bench.passes.size() == (name == "S6" ? 2 : 1));
  }
  CHECK(bench_scene_names().size() == table.size());
  CHECK(scene_named("s4BF").name == "S4bf");
  CHECK_FALSE(make_bench_scene("S8", 64, 36));
}

TEST_CASE("rows of the grid come from the north pole down, bands column by column") {
  const VertexArrays rows = arrays_of(make_ellipsoid(kFineGrid));
  CHECK(rows.vertices.size() == 6 * 501 * 1001);
  CHECK(triangle(rows, 0) == Indices{0, 1001, 1002});
  CHECK(triangle(rows, 1) == Indices{1, 1002, 1003});
  CHECK(triangle(rows, 1000) == Indices{1001, 2002, 2003});
  CHECK(triangle(rows, 1001) == Indices{1001, 2003, 1002});
  CHECK(triangle(rows, 997999) == Indices{500498, 501500, 500499});
  const VertexArrays bands = arrays_of(make_ellipsoid(kBandedGrid));
  CHECK(triangle(bands, 3) == Indices{3, 1004, 1005});
  CHECK(triangle(bands, 4) == Indices{1001, 2002, 2003});
  CHECK(triangle(bands, 997999) == triangle(rows, 997999));
}

TEST_CASE(
    "the grid's first and last vertices stand at the poles, its normals stand on the ellipsoid") {
  const Mesh mesh = make_ellipsoid(kScannedGrid);
  CHECK(mesh.positions.front() == Point<Object>(0, 1, 0));
  CHECK(mesh.positions.back().y == -1);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Point<Object>& p = mesh.positions[i];
    const double x = p.x / 1.7, y = p.y, z = p.z;
    // The squares of three coordinates, each rounded to float once, are below 1.
    REQUIRE(std::abs(x * x + y * y + z * z - 1) <= 4 * unit_roundoff<float>);
    const Normal<Object>& n = mesh.normals[i];
    const double along = n.x * p.x + n.y * p.y + n.z * p.z;
    REQUIRE(along > 0.5);
    // The normal has no tangential part: n is parallel to (x / 1.7^2, y, z).
    REQUIRE(std::abs(n.y * p.z - n.z * p.y) <= 4 * unit_roundoff<float>);
  }
}

TEST_CASE("the quads of S4 fill clip space exactly, nearest first or last") {
  for (const char* name : {"S4fb", "S4bf"}) {
    const BenchScene bench = scene_named(name);
    const Mesh& mesh = bench.scene.meshes[0];
    const auto clip_from_object =
        round_to_float(bench.passes[0].view.clip_from_eye * bench.passes[0].view.eye_from_world *
                       bench.scene.nodes[0].world_from_node);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Point<Clip> clip = clip_from_object * mesh.positions[i];
      const int k = name == std::string_view("S4fb") ? int(i) / 4 : kQuads - 1 - int(i) / 4;
      // The aspect ratio is rounded once, and so is the factor that cancels it.
      REQUIRE(std::abs(std::abs(clip.x) - 1) <= 3 * unit_roundoff<float>);
      REQUIRE(std::abs(clip.y) == 1);
      REQUIRE(clip.w == 1);
      REQUIRE(std::abs(2 * clip.z - 1 - (-0.96875 + 1.9375 * k / 63)) <= 2 * unit_roundoff<float>);
      REQUIRE(mesh.colors[i].r * 255 == float((37 * k + 20) % 256));
      REQUIRE(mesh.colors[i].g * 255 == float((91 * k + 50) % 256));
      REQUIRE(mesh.colors[i].b * 255 == float((153 * k + 90) % 256));
    }
  }
}

TEST_CASE("S3's texture has the texels of the formula") {
  const Image<Rgba8> image = make_hashed_checker();
  REQUIRE(image.width == 1024);
  REQUIRE(image.height == 1024);
  CHECK(image.at(0, 0) == Rgba8{90, 90, 90, 255});
  // For x = 1, y = 0: h = 0x9E3779B1; ^ h >> 15: 0x9E3645DF; times 0x2C1B3C6D: 0xC80103F3; ^ h >>
  // 12: 0xC80D83E3. So r = 90 + 3, g = 90 + 31/2, b = 90 + 0/2.
  CHECK(image.at(1, 0) == Rgba8{93, 105, 90, 255});
}

TEST_CASE("all of S7 lies beyond the right side of the frustum") {
  const BenchScene bench = scene_named("S7");
  const View& view = bench.passes[0].view;
  const auto clip_from_object = round_to_float(view.clip_from_eye * view.eye_from_world *
                                               bench.scene.nodes[0].world_from_node);
  for (const Point<Object>& position : bench.scene.meshes[0].positions) {
    const Point<Clip> clip = clip_from_object * position;
    REQUIRE(clip.x > clip.w);
    REQUIRE(clip.z > 0);
    REQUIRE(clip.z < clip.w);
  }
}

std::uint64_t covered_by(std::string_view name) {
  const BenchScene bench = scene_named(name);
  GlassboxPeer peer(bench);
  std::uint64_t covered = 0;
  for (const std::uint8_t pixel : peer.picture().picture.covered.pixels) covered += pixel;
  return covered;
}

TEST_CASE("the pixels covered are those of other programs, but for a handful at the outline") {
  // The counts of an independent program. A few pixels at the outline (4300 px long) differ because
  // edges are snapped differently: see PictureMatch::allowed.
  constexpr double kHandful = 34;
  CHECK(std::abs(double(covered_by("S1")) - 1225388) <= kHandful);
  CHECK(std::abs(double(covered_by("S2")) - 1225235) <= kHandful);
  CHECK(covered_by("S3") == 1920 * 1080);
  CHECK(covered_by("S4fb") == 1920 * 1080);
  CHECK(covered_by("S7") == 0);
}

TEST_CASE("S6 has the bytes of the anaglyph that shares the eyes' work") {
  const BenchScene bench = scene_named("S6", 320, 180);
  GlassboxPeer peer(bench);
  const AnaglyphMasks masks{bench.passes[0].mask, bench.passes[1].mask};
  const StereoRendering shared = render_masked_anaglyph(
      bench.scene, bench.stereo->centre, bench.stereo->pair, {bench.settings}, masks);
  CHECK(peer.picture().picture.color == shared.left.color);
}

}  // namespace
}  // namespace glassbox::study
