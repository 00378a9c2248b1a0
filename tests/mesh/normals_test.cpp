#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/mesh/normals.h>

#include "tests/mesh/polygons.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Points = std::vector<Point<Object>>;

// Newell's sums over the raw coordinates, as printed on the slide (S4.33).
template <class T>
Vector<Object, T> raw_newell(const std::vector<Point<Object, T>>& p) {
  Vector<Object, T> m(T(0), T(0), T(0));
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point<Object, T>&a = p[i], &b = p[(i + 1) % p.size()];
    m.x += (a.y - b.y) * (a.z + b.z);
    m.y += (a.z - b.z) * (a.x + b.x);
    m.z += (a.x - b.x) * (a.y + b.y);
  }
  return m;
}

// The cross product as printed on the slide (S4.32).
template <class T>
Vector<Object, T> slide_cross(const std::vector<Point<Object, T>>& p) {
  return cross(p[0] - p[1], p[2] - p[1]);
}

Vector<Object, double> widened(const Vector<Object, float>& v) {
  return {v.x, v.y, v.z};
}

ExactVector exact_newell(const Points& points) {
  const std::vector<ExactPoint> p = exact(points);
  return newell_vector<Rational>(std::span<const ExactPoint>(p));
}

// A tilted regular octagon of circumradius 1 about (offset, offset, offset).
Points octagon(double offset) {
  Points points;
  for (int i = 0; i < 8; ++i) {
    const SinCos turn = sin_cos_degrees(45.0 * i);
    points.emplace_back(float(turn.cos + offset), float(0.8 * turn.sin + offset),
                        float(0.6 * turn.sin + offset));
  }
  return points;
}

const Points kUnitSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST_CASE("the cross product and Newell's sums point to the same side of a face (E11, C-31)") {
  const Mesh square = make_polygon(kUnitSquare);
  CHECK(newell_vector(square, square.faces[0]) == Vector<Object, double>(0, 0, 2));
  CHECK(three_point_normal(kUnitSquare[0], kUnitSquare[1], kUnitSquare[2]) ==
        Vector<Object>(0, 0, 1));
  CHECK(face_normal(square, square.faces[0]) == Normal<Object>(0, 0, 1));
  CHECK(face_area(square, square.faces[0]) == 1);

  // The trap: the product on the slide points the other way, so the square would be culled.
  CHECK(slide_cross(kUnitSquare) == Vector<Object>(0, 0, -1));
}

TEST_CASE(
    "Newell's vector in rationals is the slide's sum, from whichever corner it is taken (S4-16)") {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    Points points(std::size_t(random.integer(3, 9)));
    for (auto& p : points) {
      p = {float(random.between(-9, 9)), float(random.between(-9, 9)),
           float(random.between(-9, 9))};
    }
    const ExactVector m = exact_newell(points);
    CHECK(m == raw_newell(exact(points)));
    std::rotate(points.begin(), points.begin() + 1, points.end());
    CHECK(m == exact_newell(points));
  }
}

TEST_CASE("Newell's vector in double is within its running error bound of the rational one") {
  Random random(2);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    Points points(std::size_t(random.integer(3, 12)));
    const double size = random.between(0.01, 10), offset = random.between(-1000, 1000);
    for (auto& p : points) {
      p = {float(offset + random.between(-size, size)), float(random.between(-size, size)),
           float(random.between(-size, size))};
    }
    const Mesh mesh = make_polygon(points);
    const Vector<Object, double> m = newell_vector(mesh, mesh.faces[0]);
    const ExactVector oracle = exact_newell(points);
    // The bound of Newell's sums, for z: gamma_(N+3) sum |x_i - x_n| |y_i + y_n|, with coordinates
    // relative to the first corner.
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto a = points[i], b = points[(i + 1) % points.size()], o = points[0];
      sum += std::abs(double(a.x) - b.x) * std::abs((double(a.y) - o.y) + (double(b.y) - o.y));
    }
    const double bound = double(points.size() + 3) * 0x1.001p-53 * sum;
    CHECK(abs(oracle.z - Rational(m.z)) <= Rational(bound));
  }
}

TEST_CASE("the area of a concave polygon is exact (S4-16)") {
  // An L of three unit squares.
  const Mesh mesh =
      make_polygon({{0, 0, 5}, {2, 0, 5}, {2, 1, 5}, {1, 1, 5}, {1, 2, 5}, {0, 2, 5}});
  CHECK(face_area(mesh, mesh.faces[0]) == 3);
  CHECK(face_normal(mesh, mesh.faces[0]) == Normal<Object>(0, 0, 1));
}

TEST_CASE(
    "noise in nearly collinear first corners turns the cross product, not Newell's vector (C-21)") {
  const double noise = 1e-4, bend = 1e-4;
  const Vector<Object, double> truth(0, 0, 1);
  Random random(21);
  double cross_error = 0, newell_error = 0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    Points points = {{0, 0, 0}, {0.5f, float(-bend), 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (auto& p : points) p.z = float(random.between(-noise, noise));
    const Mesh mesh = make_polygon(points);
    cross_error +=
        angle_between(truth, widened(three_point_normal(points[0], points[1], points[2])));
    newell_error += angle_between(truth, newell_vector(mesh, mesh.faces[0]));
  }
  // The cross product errs by about noise / bend = 1 rad; Newell's vector by about the noise over
  // the polygon's size.
  CHECK(cross_error / kTrials > 0.3);
  CHECK(newell_error / kTrials < 2 * noise);
}

TEST_CASE(
    "a polygon far from the origin keeps its normal when measured from its first corner (C-22)") {
  for (const double offset : {0.0, 1e2, 1e4, 1e6}) {
    CAPTURE(offset);
    const Points points = octagon(offset);
    const Vector<Object, double> truth = rounded(exact_newell(points));
    const double error =
        angle_between(truth, widened(newell_vector<float>(std::span<const Point<Object>>(points))));
    CHECK(error <= 2e-7);  // radians, in float arithmetic (C-22)
    // The trap: sums over raw coordinates.
    const double raw_error = angle_between(truth, widened(raw_newell(points)));
    if (offset == 1e4) CHECK(raw_error > 2e-4);
    if (offset == 1e6) CHECK(raw_error > 0.02);
    const Mesh mesh = make_polygon(points);
    CHECK(angle_between(truth, newell_vector(mesh, mesh.faces[0])) <= 1e-15);
  }
}

TEST_CASE("a reflex second corner reverses the cross product, not Newell's vector (C-23)") {
  const Points arrow = {{0, 0, 0}, {1, 0.5f, 0}, {2, 0, 0}, {1, 3, 0}};
  const Mesh mesh = make_polygon(arrow);
  CHECK(newell_vector(mesh, mesh.faces[0]).z > 0);
  CHECK(three_point_normal(arrow[0], arrow[1], arrow[2]).z < 0);  // the trap
}

TEST_CASE("a bow-tie has no normal at all (C-24)") {
  const Mesh mesh = make_polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(newell_vector(mesh, mesh.faces[0]) == Vector<Object, double>(0, 0, 0));
  CHECK_FALSE(face_normal(mesh, mesh.faces[0]).has_value());
  CHECK(planarity_deviation(mesh, mesh.faces[0]) == 0);
}

TEST_CASE(
    "a square with one lifted corner leans by half the lift and is bent by a quarter of it "
    "(C-26)") {
  for (const float h : {0x1p-10f, 0x1p-4f, 0.5f}) {
    CAPTURE(h);
    const Mesh mesh = make_polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, h}, {0, 1, 0}});
    const double lift = h;
    CHECK(newell_vector(mesh, mesh.faces[0]) == Vector<Object, double>(-lift, -lift, 2));
    // The expected sine is (h/2) / sqrt(4 + 2 h^2), which is h/4 to first order; four roundings
    // occur.
    const double expected = lift / 2 / std::sqrt(4 + 2 * lift * lift);
    CHECK(std::abs(planarity_deviation(mesh, mesh.faces[0]) - expected) <= 0x1p-50 * lift);
  }
}

TEST_CASE("normals of very large and very small faces are of unit length") {
  for (const float size : {1e-38f, 1e-20f, 1.0f, 1e18f, 1e38f}) {
    CAPTURE(size);
    const Mesh mesh = make_polygon({{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}});
    CHECK(face_normal(mesh, mesh.faces[0]) == Normal<Object>(0, 0, 1));
  }
}

TEST_CASE("the angle between vectors is right where the arccosine is not (S4-14)") {
  using V = Vector<Object, double>;
  CHECK(angle_between(V(1, 0, 0), V(0, 2, 0)) == kHalfPi);
  CHECK(angle_between(V(1, 1, 1), V(-1, -1, -1)) == kPi);
  CHECK(angle_between(V(0, 0, 0), V(1, 0, 0)) == 0);
  CHECK(dot(V(1, 0, 0), V(1, 3, 0)) > 0);   // acute
  CHECK(dot(V(1, 0, 0), V(-1, 3, 0)) < 0);  // obtuse
  // arctan(1e-9) = 1e-9 - 1e-27/3. In double cos(1e-9) is 1, so an arccosine would give 0.
  CHECK(std::abs(angle_between(V(1, 0, 0), V(1, 1e-9, 0)) - 1e-9) <= 1e-24);
}

}  // namespace
}  // namespace glassbox::test
