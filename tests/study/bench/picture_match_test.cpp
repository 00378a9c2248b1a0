#include <tests/support/catch.h>

#include <study/bench/glassbox_peer.h>
#include "study/scenes/picture_match.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {
namespace {

constexpr int kWidth = 320, kHeight = 180;

EnginePicture drawn(std::string_view name) {
  const auto bench = make_bench_scene(name, kWidth, kHeight);
  REQUIRE(bench);
  return GlassboxPeer(*bench).picture();
}

TEST_CASE("a picture is the same as itself") {
  for (const char* name : {"S2", "S3", "S4bf", "S6"}) {
    INFO(name);
    const EnginePicture ours = drawn(name);
    const PictureMatch found = match(ours, ours.picture);
    CHECK(found.same());
    CHECK(found.differing() == 0);
    CHECK(found.covered > 0);
    CHECK(found.covered == found.peer_covered);
    CHECK(found.pixels == kWidth * kHeight);
  }
}

TEST_CASE("colours two steps apart are the same, three steps are not") {
  const EnginePicture ours = drawn("S3");
  Picture theirs = ours.picture;
  int inside = 0;
  while (ours.edge.pixels[std::size_t(inside)] != 0) ++inside;
  std::uint8_t& red = theirs.color.pixels[std::size_t(inside)].r;
  red = std::uint8_t(red - 2);
  CHECK(match(ours, theirs).same());
  CHECK(match(ours, theirs).largest_elsewhere == 2);
  red = std::uint8_t(red - 1);
  const PictureMatch found = match(ours, theirs);
  CHECK_FALSE(found.same());
  CHECK(found.color_differs == 1);
  CHECK(found.colored_away_from_edges == 1);
}

TEST_CASE("a hole inside a triangle is found, one pixel of the outline is counted and forgiven") {
  const EnginePicture ours = drawn("S3");
  Picture theirs = ours.picture;
  int at_edge = 0, inside = 0;
  while (ours.edge.pixels[std::size_t(at_edge)] == 0) ++at_edge;
  while (ours.edge.pixels[std::size_t(inside)] != 0) ++inside;
  theirs.covered.pixels[std::size_t(at_edge)] = 0;
  CHECK(match(ours, theirs).same());
  CHECK(match(ours, theirs).coverage_differs == 1);
  theirs.covered.pixels[std::size_t(inside)] = 0;
  CHECK_FALSE(match(ours, theirs).same());
}

TEST_CASE("more differences at edges than a handful are no handful") {
  const EnginePicture ours = drawn("S2");
  const PictureMatch none = match(ours, ours.picture);
  Picture theirs = ours.picture;
  std::uint64_t planted = 0;
  for (std::size_t i = 0; planted <= none.allowed_at_edges(); ++i) {
    if (ours.edge.pixels[i] == 0 || ours.picture.covered.pixels[i] == 0) continue;
    theirs.covered.pixels[i] = 0;
    ++planted;
  }
  CHECK(match(ours, theirs).coverage_differs == planted);
  CHECK_FALSE(match(ours, theirs).same());
}

TEST_CASE("a scene that lacks one triangle, or has it the other way round, is not the same") {
  auto bench = make_bench_scene("S3", kWidth, kHeight);
  REQUIRE(bench);
  const EnginePicture ours = GlassboxPeer(*bench).picture();
  Mesh& mesh = bench->scene.meshes[0];
  std::swap(mesh.corners[0], mesh.corners[1]);
  CHECK_FALSE(match(ours, GlassboxPeer(*bench).picture().picture).same());
}

}  // namespace
}  // namespace glassbox::study
