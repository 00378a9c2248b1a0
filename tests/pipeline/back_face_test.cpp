// Back-face tests in object space, compared with rational arithmetic and with the snapped area that
// decides whether the face is drawn.
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/back_face.h>
#include <glassbox/pipeline/divide.h>

#include "tests/pipeline/rational_geometry.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using glassbox::Random;
using glassbox::test::Rational;

using Polygon = std::vector<Point<Object>>;
using Corners = std::array<Point<Object>, 3>;

ObjectViewer eye_at(double x, double y, double z) {
  return {true, {x, y, z}, {0, 0, 0}};
}
ObjectViewer gaze_along(double x, double y, double z) {
  return {false, {x, y, z}, {0, 0, 0}};
}

using RationalVector = std::array<Rational, 3>;

RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// (P - eye) . m with m by Newell's sums over the raw coordinates.
Rational exact_value(std::span<const Point<Object>> polygon, const ObjectViewer& viewer) {
  RationalVector m{0, 0, 0};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<Object>&p = polygon[i], &n = polygon[(i + 1) % polygon.size()];
    const Rational px(p.x), py(p.y), pz(p.z), nx(n.x), ny(n.y), nz(n.z);
    m[0] += (py - ny) * (pz + nz);
    m[1] += (pz - nz) * (px + nx);
    m[2] += (px - nx) * (py + ny);
  }
  const Vector<Object, double>& v = viewer.eye_or_gaze;
  const Rational vx(v.x), vy(v.y), vz(v.z);
  if (!viewer.perspective) return dot({vx, vy, vz}, m);
  const Point<Object>& p = polygon[0];
  return dot({Rational(p.x) - vx, Rational(p.y) - vy, Rational(p.z) - vz}, m);
}

int sign_of(Facing facing) {
  return facing == Facing::kBack ? 1 : facing == Facing::kFront ? -1 : 0;
}

void check_against_rationals(const BackFaceTest& test, std::span<const Point<Object>> polygon,
                             const ObjectViewer& viewer) {
  const Rational exact = exact_value(polygon, viewer);
  REQUIRE(sign_of(test.facing) == exact.sign());
  REQUIRE(abs(Rational(test.value) - exact) <= Rational(test.bound));
}

// A closed convex solid whose faces are counter-clockwise as seen from outside.
std::vector<Polygon> cube() {
  std::vector<Polygon> faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      Polygon face;
      for (const auto& [u, v] :
           {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
        std::array<float, 3> p;
        p[std::size_t(axis)] = side;
        p[std::size_t((axis + 1) % 3)] = side * u;
        p[std::size_t((axis + 2) % 3)] = v;
        face.push_back({p[0], p[1], p[2]});
      }
      faces.push_back(face);
    }
  }
  return faces;
}

std::vector<Polygon> octahedron() {
  std::vector<Polygon> faces;
  for (const float x : {-1.0f, 1.0f}) {
    for (const float y : {-1.0f, 1.0f}) {
      for (const float z : {-1.0f, 1.0f}) {
        Polygon face{{x, 0, 0}, {0, y, 0}, {0, 0, z}};
        if (x * y * z < 0) std::swap(face[1], face[2]);
        faces.push_back(face);
      }
    }
  }
  return faces;
}

// A rotation that is not exact, then a translation: all that these tests need of a view.
Transform<Eye, Object> random_eye_from_object(Random& random, double distance) {
  const double a = random.between(0, 6.28), b = random.between(0, 6.28);
  glm::dmat4 turn_y(1.0), turn_x(1.0);
  turn_y[0][0] = turn_y[2][2] = std::cos(a);
  turn_y[2][0] = std::sin(a);
  turn_y[0][2] = -std::sin(a);
  turn_x[1][1] = turn_x[2][2] = std::cos(b);
  turn_x[1][2] = std::sin(b);
  turn_x[2][1] = -std::sin(b);
  Transform<Eye, Object> m(turn_x * turn_y);
  m.at(0, 3) = random.between(-0.5, 0.5);
  m.at(1, 3) = random.between(-0.5, 0.5);
  m.at(2, 3) = -distance;
  return m;
}

}  // namespace

TEST_CASE("a face is back iff (P - eye) . m > 0 (S4-13)") {
  const Corners face{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};  // faces +z
  CHECK(test_back_face(face, eye_at(0, 0, 5)).facing == Facing::kFront);
  CHECK(test_back_face(face, eye_at(0, 0, -5)).facing == Facing::kBack);
  CHECK(test_back_face(face, gaze_along(0, 0, -1)).facing == Facing::kFront);
  CHECK(test_back_face(face, gaze_along(0, 0, 1)).facing == Facing::kBack);
  const BackFaceTest test = test_back_face(face, eye_at(0, 0, -5));
  CHECK(test.value == 5);  // P - eye = (0, 0, 5), m = (0, 0, 1)
  CHECK_FALSE(test.used_exact);
  CHECK(test_back_face(std::span(face).first(2), eye_at(0, 0, 5)).facing == Facing::kEdgeOn);
}

TEST_CASE("an eye exactly in the face's plane sees it edge-on, which counts as front (C-27)") {
  const std::uint64_t seed = 41;
  INFO("seed " << seed);
  Random random(seed);
  int rounded_to_something_else = 0;
  for (int i = 0; i < 2000; ++i) {
    // The corners are integers times 2^-10; the eye is an integer combination of them, so it is
    // exactly in the plane.
    const auto coordinate = [&] { return float(random.integer(-(1 << 20), 1 << 20)) * 0x1p-10f; };
    const Corners face{{{coordinate(), coordinate(), coordinate()},
                        {coordinate(), coordinate(), coordinate()},
                        {coordinate(), coordinate(), coordinate()}}};
    const double s = double(random.integer(-99, 99)), t = double(random.integer(-99, 99));
    const auto in_plane = [&](float a, float b, float c) {
      return double(a) + s * (double(b) - double(a)) + t * (double(c) - double(a));
    };
    const ObjectViewer viewer =
        eye_at(in_plane(face[0].x, face[1].x, face[2].x), in_plane(face[0].y, face[1].y, face[2].y),
               in_plane(face[0].z, face[1].z, face[2].z));
    const BackFaceTest test = test_back_face(face, viewer);
    REQUIRE(test.facing == Facing::kEdgeOn);
    REQUIRE(test.used_exact);
    REQUIRE_FALSE(certainly_back(test, 0));
    rounded_to_something_else += test.value != 0;
  }
  // With doubles alone the result would have been arbitrary.
  CHECK(rounded_to_something_else > 100);
}

TEST_CASE("nearly edge-on faces have the sign of rational arithmetic, and few need it (C-28)") {
  const std::uint64_t seed = 42;
  INFO("seed " << seed);
  Random random(seed);
  for (const double sine : {1e-3, 1e-5, 1e-8, 1e-13, 0.0}) {
    int fallbacks = 0, wrong_in_float = 0;
    for (int i = 0; i < 1000; ++i) {
      const auto coordinate = [&] { return float(random.between(-1, 1)); };
      const Corners face{{{coordinate(), coordinate(), coordinate()},
                          {coordinate(), coordinate(), coordinate()},
                          {coordinate(), coordinate(), coordinate()}}};
      // 10^4 away along an edge, and off the plane by the given sine.
      const auto along = [&](float a, float b, double off) {
        return a + 1e4 * (double(b) - a) + 1e4 * sine * off;
      };
      const double x = along(face[0].x, face[1].x, random.between(-1, 1));
      const double y = along(face[0].y, face[1].y, random.between(-1, 1));
      const double z = along(face[0].z, face[1].z, random.between(-1, 1));
      const ObjectViewer viewer = eye_at(x, y, z);
      const BackFaceTest test = test_back_face(face, viewer);
      CAPTURE(sine, i);
      check_against_rationals(test, face, viewer);
      fallbacks += test.used_exact;

      const Vector<Object, float> u = face[1] - face[0], v = face[2] - face[0];
      const Vector<Object, double>& e = viewer.eye_or_gaze;
      const Vector<Object, float> sight =
          face[0] - Point<Object>(float(e.x), float(e.y), float(e.z));
      const float naive = glassbox::dot(sight, glassbox::cross(u, v));
      wrong_in_float += (naive > 0) - (naive < 0) != sign_of(test.facing);
    }
    CAPTURE(sine, fallbacks, wrong_in_float);
    if (sine >= 1e-8) CHECK(fallbacks <= 10);
    if (sine <= 1e-8) CHECK(wrong_in_float > 10);
    if (sine == 0) CHECK(fallbacks > 100);
  }
}

TEST_CASE(
    "polygons of any size, concave, bent, huge and tiny, have the sign of rational arithmetic") {
  const std::uint64_t seed = 43;
  INFO("seed " << seed);
  Random random(seed);
  int fallbacks = 0;
  for (int i = 0; i < 3000; ++i) {
    const int kind = i % 3;
    Polygon polygon(std::size_t(random.integer(3, 12)));
    for (Point<Object>& p : polygon) {
      const auto coordinate = [&]() -> float {
        if (kind == 0) return float(random.integer(-2, 2));
        if (kind == 1) return float(random.scaled(-1, 1, -140, 120));
        return 1e6f + float(random.unit());
      };
      p = {coordinate(), coordinate(), coordinate()};
    }
    const auto component = [&] {
      if (kind == 0) return double(random.integer(-3, 3));
      if (kind == 1) return random.scaled(-1, 1, -150, 150);
      return 1e6 + random.unit();
    };
    const ObjectViewer viewer{i % 2 == 0, {component(), component(), component()}, {0, 0, 0}};
    CAPTURE(i);
    const BackFaceTest test = test_back_face(polygon, viewer);
    check_against_rationals(test, polygon, viewer);
    fallbacks += test.used_exact;
  }
  CHECK(fallbacks > 100);
}

TEST_CASE("the viewer in object space solves the matrix to within its stated error") {
  const std::uint64_t seed = 44;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    Transform<Eye, Object> m;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column)
        m.at(row, column) = random.between(-1, 1) * (column == 3 ? 1e3 : 1);
    }
    const bool perspective = i % 2 == 0;
    const Point<Eye, double> viewpoint{random.between(-1, 1), 0, 0};
    const auto viewer = viewer_in_object_space(m, perspective, viewpoint);
    REQUIRE(viewer.has_value());
    // Cramer's rule in rationals.
    std::array<RationalVector, 3> column;
    RationalVector right{0, 0, -1};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < 3; ++k) column[k][row] = Rational(m.at(int(row), int(k)));
      if (perspective) right[row] = -Rational(m.at(int(row), 3));
    }
    if (perspective) right[0] += Rational(viewpoint.x);
    const Rational determinant = dot(column[0], cross(column[1], column[2]));
    const RationalVector exact{dot(right, cross(column[1], column[2])) / determinant,
                               dot(column[0], cross(right, column[2])) / determinant,
                               dot(column[0], cross(column[1], right)) / determinant};
    const std::array<double, 3> got{viewer->eye_or_gaze.x, viewer->eye_or_gaze.y,
                                    viewer->eye_or_gaze.z};
    const std::array<double, 3> error{viewer->error.x, viewer->error.y, viewer->error.z};
    for (std::size_t k = 0; k < 3; ++k)
      REQUIRE(abs(Rational(got[k]) - exact[k]) <= Rational(error[k]));
  }
  Transform<Eye, Object> flat;
  flat.at(2, 2) = 0;  // C-18: no point of object space maps to the eye
  CHECK_FALSE(viewer_in_object_space(flat, true).has_value());
  CHECK_FALSE(viewer_in_object_space(flat, false).has_value());
}

TEST_CASE("the traps around (P - eye) . m give wrong answers (E18)") {
  const Polygon top = cube()[5];  // z = 1, faces +z
  REQUIRE(top[0].z == 1);
  SECTION("P has to be a vertex of the face itself") {
    // The eye is above the bottom's plane and below the top's plane, so the top is a back face.
    const ObjectViewer viewer = eye_at(5, 0, 0);
    const BackFaceTest test = test_back_face(top, viewer);
    CHECK(test.facing == Facing::kBack);
    const Vector<Object, double> m(0, 0, 8);
    const Vector<Object, double> from_bottom(1 - 5.0, 0, -1);  // P is taken from the bottom face
    CHECK(glassbox::dot(from_bottom, m) < 0);                  // wrongly a front face
  }
  SECTION("under non-uniform scale the normal does not go with the vertices' matrix") {
    // The plane x + z = 1, scaled by (4, 1, 1), becomes x/4 + z = 1 with the normal (1, 0, 4), not
    // (4, 0, 1).
    const Corners face{{{1, -1, 0}, {1, 1, 0}, {0, 0, 1}}};
    const ObjectViewer viewer = eye_at(0.75, 0, 1);
    const Vector<World, double> sight =
        Point<World, double>(4, -1, 0) - Point<World, double>(3, 0, 1);
    CHECK(test_back_face(face, viewer).facing == Facing::kFront);
    CHECK(glassbox::dot(sight, Vector<World, double>(1, 0, 4)) < 0);
    CHECK(glassbox::dot(sight, Vector<World, double>(4, 0, 1)) > 0);  // wrongly a back face
  }
  SECTION("a mirrored model turns the winding in the world, not what is outside") {
    // Mirrored in x: the eye is mirrored with the object, but the Newell vector in world space
    // points inwards.
    const ObjectViewer viewer = eye_at(-0.5, 0, 5);
    CHECK(test_back_face(top, viewer).facing == Facing::kFront);
    Polygon mirrored = top;
    for (Point<Object>& p : mirrored) p.x = -p.x;
    // Without the change of sign.
    CHECK(test_back_face(mirrored, eye_at(0.5, 0, 5)).facing == Facing::kBack);
  }
}

TEST_CASE(
    "of closed convex solids half the faces are culled, and what is left covers the same (S4-19)") {
  const std::uint64_t seed = 45;
  INFO("seed " << seed);
  Random random(seed);
  for (const std::vector<Polygon>& solid : {cube(), octahedron()}) {
    std::int64_t back = 0, all = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto coordinate = [&] { return random.between(-1000, 1000); };
      const double x = coordinate(), y = coordinate(), z = coordinate();
      const ObjectViewer viewer = eye_at(x, y, z);
      int front_here = 0;
      // m is twice the vector area, and its sum over a closed surface is zero. Seen from far away
      // in direction g, the front and the back faces have projections of the same size with
      // opposite signs: culling removes nothing that front faces do not cover.
      double front_shadow = 0, back_shadow = 0, error = 0;
      for (const Polygon& face : solid) {
        const BackFaceTest test = test_back_face(face, viewer);
        const Vector<Object, double> g = viewer.eye_or_gaze;
        const BackFaceTest shadow = test_back_face(face, gaze_along(-g.x, -g.y, -g.z));
        (shadow.facing == Facing::kBack ? back_shadow : front_shadow) += shadow.value;
        error += shadow.bound;
        back += test.facing == Facing::kBack;
        front_here += test.facing != Facing::kBack;
        ++all;
      }
      REQUIRE(front_here > 0);
      REQUIRE(std::abs(front_shadow + back_shadow) <= error);
    }
    // Each face is seen from half of the box of eyes, except for a layer of thickness 1, its
    // distance from the centre: 1/2 +- 1/1000. Each of 2000 eyes sees between a quarter and three
    // quarters of the faces, so their mean deviates by less than 5 * 0.25 / 44.
    CHECK(std::abs(double(back) / double(all) - 0.5) < 0.03);
    // From inside, everything is a back face.
    for (const Polygon& face : solid) {
      CHECK(test_back_face(face, eye_at(0.125, 0.25, -0.125)).facing == Facing::kBack);
    }
  }
}

TEST_CASE("what is certainly back has a snapped area that is back too (C-29)") {
  const std::uint64_t seed = 46;
  INFO("seed " << seed);
  Random random(seed);
  const Viewport viewport{0, 0, 640, 480};
  int culled = 0, back = 0, disagreements = 0, area_zero = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool perspective = i % 4 != 0;
    const double distance = random.between(3, 8);
    const Transform<Eye, Object> eye_from_object = random_eye_from_object(random, distance);
    // near 1, far 20: a frustum of half width 1 at w = 1, or a box of half width 2.
    Transform<Clip, Eye> clip_from_eye;
    if (perspective) {
      clip_from_eye.at(2, 2) = -20.0 / 19;
      clip_from_eye.at(2, 3) = -20.0 / 19;
      clip_from_eye.at(3, 2) = -1;
      clip_from_eye.at(3, 3) = 0;
    } else {
      clip_from_eye.at(0, 0) = clip_from_eye.at(1, 1) = 0.5;
      clip_from_eye.at(2, 2) = -1.0 / 19;
      clip_from_eye.at(2, 3) = -1.0 / 19;
    }
    const Transform<Clip, Object> clip_from_object = clip_from_eye * eye_from_object;
    const Transform<Clip, Object, float> rounded = round_to_float(clip_from_object);
    const auto viewer = viewer_in_object_space(eye_from_object, perspective);
    REQUIRE(viewer.has_value());

    // Small triangles, and slivers, whose facing often changes when they are snapped.
    const double size = std::ldexp(1.0, -int(random.integer(0, 10)));
    const std::array<double, 3> centre{random.between(-0.5, 0.5), random.between(-0.5, 0.5),
                                       random.between(-0.5, 0.5)};
    Corners face;
    for (Point<Object>& p : face) {
      p = {float(centre[0] + size * random.between(-1, 1)),
           float(centre[1] + size * random.between(-1, 1)),
           float(centre[2] + size * random.between(-1, 1))};
    }

    std::array<std::array<std::int64_t, 2>, 3> snapped;
    double largest_w = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point<Clip> p = rounded * face[k];
      largest_w = std::max(largest_w, double(p.w));
      const ScreenVertex v = to_screen(divide(p), viewport);
      snapped[k] = {std::int64_t(std::floor(double(v.position.x) * 256 + 0.5)),
                    std::int64_t(std::floor(double(v.position.y) * 256 + 0.5))};
    }
    const auto edge = [&](std::size_t from, std::size_t to, std::size_t axis) {
      return snapped[to][axis] - snapped[from][axis];
    };
    // With y down, a front face is clockwise on the screen and has a positive area here.
    const std::int64_t area = edge(0, 1, 1) * edge(0, 2, 0) - edge(0, 1, 0) * edge(0, 2, 1);
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        // 2 is added because both ends were snapped.
        longest = std::max(longest, double(std::abs(edge(k, (k + 1) % 3, axis)) + 2) / 256);
      }
    }

    // Snapping moves a vertex by at most 2^-9 px. Before that the matrix and the transform err by 5
    // u of numbers below 16, which the division multiplies by at most 2/w < 2 and the viewport by
    // 320: less than 16 * 5 * 2 * 320 u < 2^-8 px.
    const double displacement = 0x1p-9 + 0x1p-8;
    const double margin =
        snapping_margin(clip_from_object, *viewer, viewport, largest_w, longest, displacement);
    const BackFaceTest test = test_back_face(face, *viewer);
    CAPTURE(i, perspective, test.value, margin, area);
    back += area < 0;
    area_zero += area == 0;
    if (certainly_back(test, margin)) {
      ++culled;
      REQUIRE(area < 0);
    }
    if (sign_of(test.facing) * area > 0) {
      ++disagreements;
      REQUIRE(std::abs(test.value) <= test.bound + test.viewer_error_bound + margin);
    }
  }
  CAPTURE(culled, back, disagreements, area_zero);
  CHECK(culled * 2 > back);  // the margin leaves something to cull
  CHECK(disagreements > 0);  // the margin is needed
}
