#include <glassbox/base/random.h>
#include <tests/pipeline/rational.h>
#include <tests/pipeline/roundoff.h>
#include <tests/support/catch.h>

#include <cmath>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/formulas.h>
#include <glassbox/pipeline/normal_transform.h>

namespace glassbox {
namespace {

using Linear = Transform<World, Object>;
using Vec = glm::dvec3;

using test::uf;

Vec unit_of(const Vec& v) {
  return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// The angle between two directions, accurate near 0.
double angle(const Vec& a, const Vec& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

TEST_CASE(
    "normals stay perpendicular under squashing by a million, where the matrix itself is 90 "
    "degrees off (C-16)") {
  const Linear squash = scale<World, Object>(1, 1, 1e-6);
  const Normal<Object> slope{0.6f, 0, 0.8f};
  const Normal<World> right = normalized(normal_transform(squash) * slope);
  // The surface's tangents (0.8, 0, -0.6) and y become (0.8, 0, -0.6e-6) and y.
  const Vec exact = unit_of(Vec(double(slope.x) * 1e-6, 0, double(slope.z)));
  CHECK(angle(Vec(to_glm(right)), exact) <= 10 * uf);
  const Vec wrong = Vec(slope.x, slope.y, double(slope.z) * 1e-6);
  CHECK(angle(unit_of(wrong), exact) > 1.57);
}

TEST_CASE("normals of random transforms are within 10 u of the exact cofactors' (C-16, oracle Q)") {
  Random random(80);
  for (int i = 0; i < 2000; ++i) {
    Linear m;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        m.at(row, column) = double(random.integer(-99, 99));
    }
    const Vec columns[] = {Vec(m.columns[0]), Vec(m.columns[1]), Vec(m.columns[2])};
    // Small integers: exact in double.
    const Vec cofactors[] = {glm::cross(columns[1], columns[2]), glm::cross(columns[2], columns[0]),
                             glm::cross(columns[0], columns[1])};
    const double det = glm::dot(columns[0], cofactors[0]);
    const Normal<Object> n{float(random.between(-1, 1)), float(random.between(-1, 1)),
                           float(random.between(-1, 1))};
    const Vec exact =
        (cofactors[0] * double(n.x) + cofactors[1] * double(n.y) + cofactors[2] * double(n.z)) *
        (det < 0 ? -1.0 : 1.0);
    const Normal<World> value = normalized(normal_transform(m) * n);
    // Rounding is relative to the terms, so cancellation magnifies the error.
    double terms = 0, size = glm::length(exact);
    for (int k = 0; k < 3; ++k) terms += glm::length(cofactors[k]);
    if (size == 0) continue;
    CAPTURE(i, det);
    CHECK(angle(Vec(to_glm(value)), exact) <= 10 * uf * std::max(1.0, terms / size));
  }
}

TEST_CASE("mirrored objects keep their normals outward (C-17)") {
  const Linear mirror = scale<World, Object>(-1, 1, 1);
  const Normal<World> right = normalized(normal_transform(mirror) * Normal<Object>(1, 0, 0));
  const Normal<World> up = normalized(normal_transform(mirror) * Normal<Object>(0, 1, 0));
  CHECK(right == Normal<World>(-1, 0, 0));
  CHECK(up == Normal<World>(0, 1, 0));
  // Without the sign of the determinant the cofactors point inward.
  const glm::dmat3 m(mirror.columns);
  CHECK(glm::cross(m[1], m[2]) == Vec(1, 0, 0));
  // On a closed shape, the outward normal of every face has a positive dot product with the
  // direction out, for any mirrored map.
  const Linear map = *rotate_degrees<World, Object>({1, 2, 3}, 77) * scale<Object>(-2, 3, 0.5);
  for (const Vec& n :
       {Vec(1, 0, 0), Vec(-1, 0, 0), Vec(0, 1, 0), Vec(0, -1, 0), Vec(0, 0, 1), Vec(0, 0, -1)}) {
    const Normal<World> outward = normal_transform(map) * Normal<Object>(glm::vec3(n));
    // The centre of the cube's face, which is also the direction out.
    const Vector<World, double> way_out = map * Vector<Object, double>(n);
    CHECK(outward.x * way_out.x + outward.y * way_out.y + outward.z * way_out.z > 0);
  }
}

TEST_CASE("a flattened object has the right normals where it has any, and no NaN (C-18)") {
  const Linear flat = scale<World, Object>(2, 3, 0);
  CHECK(normalized(normal_transform(flat) * Normal<Object>(0, 0, 1)) == Normal<World>(0, 0, 1));
  CHECK(normalized(normal_transform(flat) * Normal<Object>(0.6f, 0, 0.8f)) ==
        Normal<World>(0, 0, 1));
  CHECK(normalized(normal_transform(flat) * Normal<Object>(1, 0, 0)) == Normal<World>(0, 0, 0));
  const Linear nothing = scale<World, Object>(0, 0, 0);
  CHECK(normalized(normal_transform(nothing) * Normal<Object>(1, 2, 3)) == Normal<World>(0, 0, 0));
  // The textbook's inverse transpose would divide by this determinant.
  CHECK(!inverse_affine(flat));
}

TEST_CASE("sizes that overflow or vanish in float and double do not matter") {
  const Normal<Object> n{0.6f, 0, 0.8f};
  const Normal<World> plain = normalized(normal_transform(scale<World, Object>(1, 2, 3)) * n);
  for (int e : {-600, -300, -60, 60, 300, 600}) {
    const double s = std::ldexp(1.0, e);
    CHECK(normalized(normal_transform(scale<World, Object>(s, 2 * s, 3 * s)) * n) == plain);
  }
}

TEST_CASE(
    "a unit normal has length 1 from the smallest float to the largest, and zero stays zero") {
  for (const float length : {0x1p-149f, 1e-38f, 1e-31f, 1.0f, 1e30f, 0x1.fffffep127f}) {
    CAPTURE(length);
    CHECK(unit_normal<float>({length, 0, 0}) == std::array{1.0f, 0.0f, 0.0f});
    CHECK(unit_normal<float>({0, -length, 0}) == std::array{0.0f, -1.0f, 0.0f});
  }
  CHECK(unit_normal<float>({0, 0, 0}) == std::array{0.0f, 0.0f, 0.0f});
}

TEST_CASE(
    "a parallel view's depth is a distance from its near plane, or from its far one if reversed") {
  for (const bool reversed : {false, true}) {
    CHECK(parallel_distance(0.0f, reversed, 2, 10) == (reversed ? 10.0f : 2.0f));
    CHECK(parallel_distance(1.0f, reversed, 2, 10) == (reversed ? 2.0f : 10.0f));
    CHECK(parallel_distance(0.25f, reversed, 2, 10) == (reversed ? 8.0f : 4.0f));
  }
}

}  // namespace
}  // namespace glassbox
