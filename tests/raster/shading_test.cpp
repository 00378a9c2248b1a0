// Lighting of surfaces.
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/raster/light_formulas.h>
#include <glassbox/raster/shading.h>

#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using Float3 = std::array<float, 3>;
using Decimal = boost::multiprecision::cpp_bin_float_50;

Light directional(double lux) {
  Light light;
  light.intensity = lux;
  light.direction = {0, 0, -1};
  return light;
}

Light point(double candela, double z) {
  Light light;
  light.kind = LightKind::kPoint;
  light.intensity = candela;
  light.position = {0, 0, z};
  return light;
}

Lighting lighting_of(const Light& light) {
  Scene scene;
  scene.lights = {light};
  return light_scene(scene, View{});
}

constexpr Float3 kOrigin{0, 0, 0};
constexpr Float3 kBelow{0, 0, -1};  // in front of the viewer
constexpr Float3 kFacing{0, 0, 1};

}  // namespace

TEST_CASE(
    "a white matte surface facing a directional light of pi lux gets diffuse 1 beside the ambient "
    "0.1, exactly") {
  const Lighting lighting = lighting_of(directional(kPi));
  const Reflection light = illuminate(lighting, kBelow, kFacing, 16);
  CHECK(light.diffuse == Float3{1.0f + 0.1f, 1.0f + 0.1f, 1.0f + 0.1f});
  CHECK(light.specular == Float3{1, 1, 1});  // the viewer is where the light comes from
  // The length of the normal has no effect.
  CHECK(illuminate(lighting, kBelow, {0, 0, 8}, 16).diffuse == light.diffuse);
}

TEST_CASE(
    "light falls off with the cosine, and a surface that faces away gets only the ambient light") {
  const Lighting lighting = lighting_of(directional(kPi));
  for (int degrees = 0; degrees <= 180; degrees += 5) {
    const SinCos angle = sin_cos_degrees(degrees);
    const Reflection light =
        illuminate(lighting, kBelow, {float(angle.sin), 0, float(angle.cos)}, 16);
    CAPTURE(degrees);
    // The normal's components, its length, its reciprocal and their product, the dot product and
    // the sum: 8 roundings of numbers up to 1.1.
    CHECK(std::abs(light.diffuse[0] - (0.1 + std::max(0.0, angle.cos))) <= 9 * 0x1p-24);
    if (degrees > 90) CHECK(light.diffuse == Float3{0.1f, 0.1f, 0.1f});
    if (degrees > 90) CHECK(light.specular == Float3{0, 0, 0});
  }
}

TEST_CASE("a zero normal receives only the ambient light") {
  for (const Light& light : {directional(kPi), point(kPi, 1)}) {
    const Reflection reflection = illuminate(lighting_of(light), kBelow, {0, 0, 0}, 16);
    CHECK(reflection.diffuse == Float3{0.1f, 0.1f, 0.1f});
    CHECK(reflection.specular == Float3{0, 0, 0});
  }
}

TEST_CASE("a scene without lights gets a headlight of 0.9 pi lux along (1, 1, 2)") {
  const Lighting lighting = light_scene(Scene{}, View{});
  REQUIRE(lighting.lights.size() == 1);
  const Reflection facing = illuminate(lighting, kBelow, {1, 1, 2}, 16);
  CHECK(std::abs(facing.diffuse[0] - 1.0) <= 9 * 0x1p-24);
  const Reflection level = illuminate(lighting, kBelow, kFacing, 16);
  CHECK(std::abs(level.diffuse[0] - (0.1 + 0.9 * 2 / std::sqrt(6.0))) <= 9 * 0x1p-24);
}

TEST_CASE("a point light falls off with the square of the distance, and to nothing at its range") {
  const auto received = [](const Light& light) {
    return illuminate(lighting_of(light), kOrigin, kFacing, 16).diffuse[0] - 0.1f;
  };
  // Powers of two: every product is exact, and (0.1f + x) - 0.1f loses at most an ulp of 1.1.
  const auto is = [](float found, double expected) {
    return std::abs(found - expected) <= 0x1p-23;
  };
  CHECK(is(received(point(kPi, 1)), 1));
  CHECK(is(received(point(4 * kPi, 2)), 1));
  CHECK(is(received(point(kPi, 8)), 1.0 / 64));
  Light ranged = point(4 * kPi, 2);
  ranged.range = 4;
  CHECK(is(received(ranged), 1 - 1.0 / 16));  // 1 - (d / range)^4
  ranged.range = 2;
  CHECK(received(ranged) == 0.0f);
  ranged.range = 1;
  CHECK(received(ranged) == 0.0f);
}

TEST_CASE(
    "a spot light is full within its inner cone, nothing outside the outer, and squared in "
    "between") {
  Light spot = point(kPi, 1);
  spot.kind = LightKind::kSpot;
  spot.direction = {0, 0, -1};
  spot.inner_cone_radians = radians_from_degrees(20);
  spot.outer_cone_radians = radians_from_degrees(40);
  const Lighting lighting = lighting_of(spot);
  Lighting plain = lighting;
  plain.lights[0].kind = LightKind::kPoint;
  const double inner = std::cos(spot.inner_cone_radians), outer = std::cos(spot.outer_cone_radians);
  for (int degrees = 0; degrees < 80; ++degrees) {
    // A point on the plane z = 0, seen from the light at this angle to the light's axis.
    const Float3 at{float(std::tan(radians_from_degrees(degrees))), 0, 0};
    const double whole = double(illuminate(plain, at, kFacing, 1).diffuse[0]) - double(0.1f);
    const double part = double(illuminate(lighting, at, kFacing, 1).diffuse[0]) - double(0.1f);
    const double cosine = std::cos(radians_from_degrees(degrees));
    const double cone = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    CAPTURE(degrees, part, whole);
    // The cosine has a few roundings, which the cone multiplies by 2 / (inner - outer) = 12; the
    // sum with the ambient light has an error of an ulp of 1.
    CHECK(std::abs(part - cone * cone * whole) <= 12 * 8 * 0x1p-24 + 0x1p-23);
    if (degrees > 40) CHECK(part == 0);
  }
}

TEST_CASE("the highlight is the cosine to the power of the shininess, within n - 1 roundings") {
  // A parallel view along the light: the half vector h is exactly (0, 0, 1), and without ambient
  // light the diffuse part is the cosine.
  Lighting lighting = lighting_of(directional(kPi));
  lighting.perspective = false;
  lighting.ambient = 0;
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const int n = i < 40 ? i + 1 : int(random.integer(1, 1024));
    const float tilt = float(random.between(0, 4.0 / std::sqrt(double(n))));
    const Reflection light = illuminate(lighting, kBelow, {tilt, 0, 1}, n);
    const float cosine = light.diffuse[0];
    // Squaring doubles the relative error and adds u, so the power 2^k has an error of (2^k - 1) u,
    // and the product of the powers one of (n - 1) u.
    Decimal exact = 1;  // 50 digits, less three for the 1024 products
    for (int k = 0; k < n; ++k) exact *= cosine;
    CAPTURE(n, tilt, cosine, light.specular[0]);
    if (exact < 1e-18) continue;                         // smaller squares underflow
    const Decimal bound = Decimal(n) / ((1 << 24) - n);  // n u / (1 - n u)
    REQUIRE(abs(Decimal(light.specular[0]) - exact) <= bound * exact);
    if (n == 1) REQUIRE(light.specular[0] == cosine);
  }
}

TEST_CASE("no highlight is brighter than the light: a cosine that rounding leaves above 1 is 1") {
  const Lighting lighting = lighting_of(directional(kPi));
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    // The viewer is where the light comes from, and the surface faces both; its normal has any
    // length.
    const float length = float(random.between(1, 2));
    const Float3 normal{0, 0, length};
    const Reflection light = illuminate(lighting, {0, 0, -length}, normal, 1 << 20);
    REQUIRE(light.specular[0] <= 1);
    // Then seen from the side, with a normal along the half vector h.
    const float x = float(random.between(-1, 1)), y = float(random.between(-1, 1));
    const Float3 viewer = unit<float>({x, y, 1});
    const Float3 half = unit<float>({viewer[0], viewer[1], viewer[2] + 1});
    REQUIRE(illuminate(lighting, {-x, -y, -1}, half, 1 << 20).specular[0] <= 1);
  }
}

TEST_CASE(
    "in a parallel view the highlight is the same everywhere, in a perspective one it moves") {
  Lighting lighting = lighting_of(directional(kPi));
  const Float3 tilted{0.2f, 0, 1}, aside{3, 0, -1};
  CHECK(illuminate(lighting, aside, tilted, 8).specular !=
        illuminate(lighting, kBelow, tilted, 8).specular);
  lighting.perspective = false;
  CHECK(illuminate(lighting, aside, tilted, 8).specular ==
        illuminate(lighting, kBelow, tilted, 8).specular);
}

TEST_CASE("a surface without a normal shows its own colour, and no light") {
  const Float3 base{0.25f, 0.5f, 0.75f}, white{1, 1, 1};
  const Reflection light{{2, 2, 2}, {3, 3, 3}};
  CHECK(reflected_color<float>(base, {0, 0, 0}, light, white, true) == base);
  CHECK(reflected_color<float>(base, {0, 0, 1e-30f}, light, white, true) == Float3{3.5f, 4, 4.5f});
  CHECK(reflected_color<float>(base, {0, 0, 1}, light, white, false) == Float3{0.5f, 1, 1.5f});
}

TEST_CASE("light is finite however strong and near the source: bright is never black") {
  for (const double candela : {1.0, 1e38, 1e300}) {
    for (const double distance : {1e-30, 1e-21, 1e-10, 1.0}) {
      Light light = point(candela, distance);
      light.color = {1, 0, 1e-30f};
      // The surface's normal points to the light, or is nearly perpendicular to its direction, so
      // that the highlight is 0.
      for (const Float3& normal : {kFacing, Float3{1, 0, 1e-3f}}) {
        const Reflection reflection = illuminate(lighting_of(light), kOrigin, normal, 1024);
        CAPTURE(candela, distance);
        for (std::size_t i = 0; i < 3; ++i) {
          CHECK(std::isfinite(reflection.diffuse[i]));
          CHECK(std::isfinite(reflection.specular[i]));
          CHECK(reflection.diffuse[i] >= 0.1f);
        }
      }
    }
  }
  // At the position of the light there is no direction to it.
  const Reflection at = illuminate(lighting_of(point(1, 0)), kOrigin, kFacing, 16);
  CHECK(at.diffuse == Float3{0.1f, 0.1f, 0.1f});
}

TEST_CASE("lights are carried into eye space, and add up") {
  // The eye is at (10, 0, 0) and looks along the world's +x: eye z is world -x, eye x is world z.
  View view;
  view.eye_from_world =
      Transform<Eye, World>(glm::dmat4(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 10, 1));
  Scene scene;
  Light sun = directional(kPi);
  sun.direction = {1, 0, 0};  // along the gaze
  Light lamp = point(kPi, 0);
  lamp.position = {9, 0, 0};  // one unit behind the eye
  scene.lights = {sun, lamp};
  const Lighting lighting = light_scene(scene, view);
  CHECK(lighting.lights[0].towards == Vector<Eye>{0, 0, 1});
  CHECK(lighting.lights[1].position == Point<Eye>{0, 0, 1});
  CHECK(illuminate(lighting, kOrigin, kFacing, 16).diffuse[0] == 0.1f + 1.0f + 1.0f);
}
