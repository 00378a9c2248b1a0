// The measurements on a scene for a recommendation, compared with what must be true.
#include <tests/support/catch.h>

#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include <glassbox/mesh/formats/load.h>

#include "study/recommend/pictures.h"
#include "study/recommend/vertices.h"

namespace glassbox::study {
namespace {

// A view from six units in front of the origin, towards it.
View view_of(DepthRange range, double near, double far) {
  Camera camera;
  camera.lens = PerspectiveLens{0.8, near, far};
  camera.world_from_eye = Transform<World, Eye>(glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 6)));
  return *make_view(camera, 640, 480, range);
}

TEST_CASE(
    "positions: double leaves only the snap's error, and float some ten thousandths of a pixel "
    "more") {
  const auto scene = load_scene("sphere");
  REQUIRE(scene);
  const auto vertices = SceneVertices::sample(*scene, view_of(DepthRange::kStandard, 1, 20));
  REQUIRE(vertices);
  REQUIRE(vertices->count() > 100);
  const Comparison positions = vertices->positions();
  REQUIRE(positions.candidates.size() == 15);
  for (const Candidate& each : positions.candidates) {
    INFO(each.name);
    // Each coordinate is moved by at most half a step; among hundreds of vertices some are moved by
    // more than a quarter of that. Float adds about ten roundings of 2^-24 of at most 640 px, 4e-4
    // px.
    const auto at = each.name.find("; ");
    const int bits = std::stoi(each.name.substr(at + 2));
    const double step = std::ldexp(1.0, -bits), most = step * std::sqrt(0.5);
    const bool in_double = each.name.starts_with("double");
    CHECK(each.error <= most + (in_double ? 1e-9 : 4e-4));
    CHECK(each.error >= step / 8);
    CHECK_FALSE(each.ns);
  }
}

TEST_CASE("depth: each format errs by its own step, carried to the distance") {
  const auto scene = load_scene("sphere");
  REQUIRE(scene);
  const double near = 0.5, far = 1000;
  const auto standard = SceneVertices::sample(*scene, view_of(DepthRange::kStandard, near, far));
  const auto reversed = SceneVertices::sample(*scene, view_of(DepthRange::kReversed, near, far));
  REQUIRE(standard);
  REQUIRE(reversed);
  // dz/z = z dd (f - n)/(f n), where z is between 4.9 and 7.1 from the eye (B.3). dd is half a step
  // of the format; floats near depth 1 add half an ulp of 2^-24 several times, for the division and
  // for z itself.
  const double scale = (far - near) / (far * near);
  for (const auto& [format, half_step] : {std::pair(DepthFormat::kUnorm16, 0.5 / 65535),
                                          std::pair(DepthFormat::kUnorm24, 0.5 / 16777215)}) {
    const double error = standard->depth_error(format);
    CHECK(error <= 7.1 * scale * (half_step + 4 * 0x1p-24));
    CHECK(error >= 4.9 * scale * half_step / 2);
  }
  // Reversed depth has the relative error of a float, a few 2^-24 at every distance.
  CHECK(reversed->depth_error(DepthFormat::kFloat32Reversed) < 8 * 0x1p-24);
  CHECK(reversed->depth_error(DepthFormat::kFloat32Reversed) > 0);
  CHECK(standard->depth_error(DepthFormat::kFloat32) > 8 * 0x1p-24);
}

TEST_CASE("a scene with no vertex between the planes is refused with a remedy") {
  const auto scene = load_scene("sphere");
  REQUIRE(scene);
  const auto none = SceneVertices::sample(*scene, view_of(DepthRange::kStandard, 100, 200));
  REQUIRE_FALSE(none);
  CHECK_FALSE(none.error().remedy.empty());
}

TEST_CASE("a picture is shrunk by averaging light, not bytes") {
  Image<Rgba8> large(4, 2, Rgba8{0, 0, 0, 255});
  for (int y = 0; y < 2; ++y)
    large.at(0, y) = large.at(2, y) = large.at(3, y) = {255, 255, 255, 255};
  const Image<Rgba8> light = downsample(large, 2, Transfer::kSrgb);
  REQUIRE(light.width == 2);
  REQUIRE(light.height == 1);
  CHECK(light.at(0, 0) == Rgba8{188, 188, 188, 255});  // one half by IEC 61966-2-1: 187.5...
  CHECK(light.at(1, 0) == Rgba8{255, 255, 255, 255});
  CHECK(downsample(large, 2, Transfer::kNone).at(0, 0) == Rgba8{128, 128, 128, 255});
}

TEST_CASE("the colour error is the root mean square over red, green and blue") {
  Image<Rgba8> a(2, 1, Rgba8{10, 20, 30, 255}), b = a;
  CHECK(color_error(a, b) == 0);
  b.at(1, 0).g = 26;
  b.at(1, 0).a = 0;  // alpha is not compared
  CHECK(color_error(a, b) == Approx(std::sqrt(36.0 / 6) / 255));
  CHECK(color_error(a, b) == color_error(b, a));
}

}  // namespace
}  // namespace glassbox::study
