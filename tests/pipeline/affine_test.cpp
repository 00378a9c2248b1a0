#include <glassbox/base/random.h>
#include <tests/pipeline/rational.h>
#include <tests/pipeline/roundoff.h>
#include <tests/support/catch.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/unit_vector.h>

namespace glassbox {
namespace {

using test::Rational;
using test::RationalMatrix;

using test::u;
using WorldMap = Transform<World, World>;

WorldMap rotation(const Vector<World, double>& axis, double degrees) {
  const auto r = rotate_degrees<World>(axis, degrees);
  REQUIRE(r);
  return *r;
}

double largest_difference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
    }
  }
  return largest;
}

TEST_CASE(
    "quarter turns about the axes are exact and counter-clockwise seen from the axis (S3-06)") {
  const WorldMap z = rotation({0, 0, 3}, 90), x = rotation({2, 0, 0}, 90),
                 y = rotation({0, 7, 0}, 90);
  CHECK(z * Point<World, double>(1, 0, 0) == Point<World, double>(0, 1, 0));
  CHECK(x * Point<World, double>(0, 1, 0) == Point<World, double>(0, 0, 1));
  CHECK(y * Point<World, double>(0, 0, 1) == Point<World, double>(1, 0, 0));
  CHECK(rotation({0, 0, 1}, 180) == scale<World>(-1, -1, 1));
  CHECK(rotation({0, 0, 1}, 360) == WorldMap{});
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double entry = rotation({0, 0, -1}, 270).at(row, column);
      CHECK(!(entry == 0 && std::signbit(entry)));
    }
  }
}

TEST_CASE("a rotation about an axis agrees with GLM and is orthogonal to 16 u (S3-06)") {
  Random random(30);
  for (int i = 0; i < 5000; ++i) {
    const Vector<World, double> axis{random.between(-1, 1), random.between(-1, 1),
                                     random.between(-1, 1)};
    const double degrees = random.between(-720, 720);
    const WorldMap ours = rotation(axis, degrees);
    // GLM takes radians, which are rounded (720 degrees: 2^3 u), and uses sine and cosine of the C
    // library.
    const glm::dmat4 glm = glm::rotate(glm::dmat4(1), degrees * (kPi / 180), to_glm(axis));
    CAPTURE(i, axis.x, axis.y, axis.z, degrees);
    CHECK(largest_difference(ours.columns, glm) <= 40 * u);
    CHECK(orthogonality_error(glm::dmat3(ours.columns)) <= 16 * u);
  }
}

TEST_CASE("an axis that is no direction and an angle without bound are refused (C-03)") {
  const double nan = std::nan("");
  CHECK(!rotate_degrees<World>({0, 0, 0}, 30));
  CHECK(!rotate_degrees<World>({nan, 0, 1}, 30));
  CHECK(!rotate_degrees<World>({0, 0, 1}, nan));
  CHECK(!rotate_degrees<World>({0, 0, 1}, INFINITY));
  CHECK(rotate_degrees<World>({0, 0, 1e-300}, 90).value() == rotation({0, 0, 1}, 90));
  CHECK(rotate_degrees<World>({0, 0, 0}, 30).error().message() ==
        "rotation axis: (0, 0, 0) is not a direction; give three finite numbers that are not all "
        "zero");
}

TEST_CASE("T R and R T differ by (R - I) a, exactly where R is exact (S3-04, C-19)") {
  const Vector<World, double> a{3, -5, 8};
  const WorldMap t = translate<World>(a), r = rotation({0, 0, 1}, 90);
  const WorldMap tr = t * r, rt = r * t;
  CHECK(tr != rt);
  const Vector<World, double> expected = r * a - a;
  CHECK(rt.at(0, 3) - tr.at(0, 3) == expected.x);
  CHECK(rt.at(1, 3) - tr.at(1, 3) == expected.y);
  CHECK(rt.at(2, 3) - tr.at(2, 3) == expected.z);
}

TEST_CASE(
    "the building blocks do what they say, and are undone by the transposed, negated, inverse ones "
    "(S3-04)") {
  const Point<World, double> p{1, 2, 3};
  CHECK(translate<World>({10, 20, 30}) * p == Point<World, double>(11, 22, 33));
  CHECK(scale<World>(2, -3, 0.5) * p == Point<World, double>(2, -6, 1.5));
  CHECK(shear<World>(Axis::kX, Axis::kZ, 2) * p == Point<World, double>(7, 2, 3));
  CHECK(translate<World>({1, 2, 3}) * translate<World>({-1, -2, -3}) == WorldMap{});
  CHECK(inverse_affine(shear<World>(Axis::kX, Axis::kZ, 2)).value() ==
        shear<World>(Axis::kX, Axis::kZ, -2));
  CHECK(inverse_rigid(rotation({0, 0, 1}, 90)) == rotation({0, 0, 1}, -90));
}

TEST_CASE("the rigid inverse is the transpose and undoes the map to rounding (S4-03)") {
  Random random(31);
  for (int i = 0; i < 1000; ++i) {
    const Vector<World, double> to{random.between(-9, 9), random.between(-9, 9),
                                   random.between(-9, 9)};
    const Vector<World, double> axis{random.between(-1, 1), random.between(-1, 1),
                                     random.between(-1, 1)};
    const WorldMap m = translate<World>(to) * rotation(axis, random.between(0, 360));
    // The rotation part is orthogonal up to 8 u; the translation has |t| <= 16 times that error,
    // and gamma_4.
    CHECK(largest_difference((inverse_rigid(m) * m).columns, glm::dmat4(1)) <= 16 * 24 * u);
  }
}

TEST_CASE(
    "the affine inverse is within its condition of the exact one, and flat maps are refused "
    "(C-18)") {
  Random random(32);
  for (int i = 0; i < 300; ++i) {
    WorldMap m;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) m.at(row, column) = double(random.integer(-9, 9));
    }
    const Result<WorldMap> inverse = inverse_affine(m);
    const RationalMatrix exact = test::exactly(m);
    const auto minor = [&](int r1, int r2, int c1, int c2) {
      return m.at(r1, c1) * m.at(r2, c2) - m.at(r1, c2) * m.at(r2, c1);
    };
    const double det = m.at(0, 0) * minor(1, 2, 1, 2) - m.at(0, 1) * minor(1, 2, 0, 2) +
                       m.at(0, 2) * minor(1, 2, 0, 1);  // small integers: exact
    CAPTURE(i, det);
    REQUIRE(bool(inverse) == (det != 0));
    if (!inverse) continue;
    const RationalMatrix product = test::exactly(*inverse) * exact;
    // Cofactors and determinant of small integers are exact, so each entry of the inverse has a
    // relative error of u, and the product an error of 3 . 9 u max|inverse|; the last column has
    // one more multiplication.
    double largest = 1;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column)
        largest = std::max(largest, std::abs(inverse->at(row, column)));
    }
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        CHECK(test::error_of(row == column ? 1 : 0, product.at[row][column]) <= 150 * u * largest);
      }
    }
  }
  CHECK(!inverse_affine(scale<World>(1, 1, 0)));
  CHECK(inverse_affine(scale<World>(1, 1, 1e-200)));
  CHECK(inverse_affine(scale<World>(0x1p-900, 0x1p-900, 0x1p-900)).value() ==
        scale<World>(0x1p900, 0x1p900, 0x1p900));
  CHECK(!inverse_affine(scale<World>(1, 1, std::nan(""))));
}

TEST_CASE("axis and angle come back from a rotation (S3-06)") {
  Random random(33);
  for (int i = 0; i < 2000; ++i) {
    const Vector<World, double> axis = *unit(
        Vector<World, double>{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    const double degrees = random.between(1, 179);
    const AxisAngle found = axis_angle_of(rotation(axis, degrees));
    CAPTURE(i, axis.x, axis.y, axis.z, degrees);
    // The entries err by 8 u. Near 0 and 180 degrees the axis errs by that over the sine
    // (1/0.0175), which dominates.
    CHECK(std::abs(found.radians - radians_from_degrees(degrees)) <= 32 * u);
    CHECK(std::abs(found.axis.x - axis.x) <= 16 * u / 0.0174);
    CHECK(std::abs(found.axis.y - axis.y) <= 16 * u / 0.0174);
    CHECK(std::abs(found.axis.z - axis.z) <= 16 * u / 0.0174);
  }
}

TEST_CASE("small angles come back to 4 u where the arccosine of the slides loses them all (C-04)") {
  for (double radians : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    const WorldMap r = rotation({0, 0, 1}, degrees_from_radians(radians));
    const AxisAngle found = axis_angle_of(r);
    CAPTURE(radians);
    // 1.5 ulps for the conversion from degrees and back, and the error of axis_angle_of.
    CHECK(std::abs(found.radians - radians) <= 8 * u * radians);
    CHECK(found.axis == glm::dvec3(0, 0, 1));
  }
  // The wrong variant, acos((tr - 1)/2), at 1e-8: the cosine rounds to 1.
  const WorldMap r = rotation({0, 0, 1}, degrees_from_radians(1e-8));
  CHECK(std::acos(0.5 * (r.at(0, 0) + r.at(1, 1) + r.at(2, 2) - 1)) == 0);
}

TEST_CASE("axes of half turns come from R + R^T (C-05)") {
  Random random(34);
  for (double away_degrees : {0.0, 1e-12, 1e-9, 1e-6, 1e-3, 1.0}) {
    for (int i = 0; i < 200; ++i) {
      const Vector<World, double> axis = *unit(Vector<World, double>{
          random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
      const AxisAngle found = axis_angle_of(rotation(axis, 180 - away_degrees));
      const double along = found.axis.x * axis.x + found.axis.y * axis.y + found.axis.z * axis.z;
      CAPTURE(away_degrees, i);
      CHECK(std::abs(found.radians - radians_from_degrees(180 - away_degrees)) <= 32 * u);
      // Close to 180 degrees, where rounding decides the direction, the axis may come back negated.
      const double sign = along < 0 ? -1 : 1;
      if (away_degrees >= 1e-9) CHECK(sign == 1);
      CHECK(std::abs(found.axis.x - sign * axis.x) <= 32 * u);
      CHECK(std::abs(found.axis.y - sign * axis.y) <= 32 * u);
      CHECK(std::abs(found.axis.z - sign * axis.z) <= 32 * u);
    }
  }
}

TEST_CASE("drift of repeated products is removed by the nearest rotation (C-11)") {
  // The products of 100 000 float rotations by 0.01 rad: without repair the axes drift by about u/3
  // per product.
  const glm::mat4 step = glm::mat4(rotation({1, 2, 3}, degrees_from_radians(0.01)).columns);
  glm::mat4 drifting(1), repaired(1);
  for (int i = 1; i <= 100000; ++i) {
    drifting = step * drifting;
    repaired = step * repaired;
    if (i % 1000 == 0) {
      const auto nearest = nearest_rotation(glm::dmat3(repaired));
      REQUIRE(nearest);
      CHECK(nearest->largest_change < 1000 * 3 * 0x1p-24);
      repaired = glm::mat4(glm::dmat4(nearest->rotation));
    }
  }
  CHECK(orthogonality_error(glm::dmat3(drifting)) > 1e-4);
  CHECK(orthogonality_error(glm::dmat3(repaired)) <= 8 * 0x1p-24);
}

TEST_CASE(
    "the nearest rotation is orthogonal to 8 u, changes rotations by rounding only, and refuses "
    "mirrors (C-12)") {
  Random random(35);
  for (int i = 0; i < 500; ++i) {
    const Vector<World, double> axis{random.between(-1, 1), random.between(-1, 1), 0.1};
    const WorldMap r = rotation(axis, random.between(0, 360));
    glm::dmat3 noisy(r.columns);
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) noisy[column][row] += random.between(-1e-6, 1e-6);
    }
    const auto exact = nearest_rotation(glm::dmat3(r.columns)), near = nearest_rotation(noisy);
    REQUIRE(exact);
    REQUIRE(near);
    CHECK(exact->largest_change <= 8 * u);
    CHECK(near->largest_change <= 4e-6);
    CHECK(orthogonality_error(near->rotation) <= 8 * u);
  }
  CHECK(!nearest_rotation(glm::dmat3(-1)));
  CHECK(!nearest_rotation(glm::dmat3(0)));
  CHECK(
      !nearest_rotation(glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(1, 1, 0))));
  CHECK(!nearest_rotation(glm::dmat3(std::nan(""))));
  CHECK(nearest_rotation(glm::dmat3(5))->rotation == glm::dmat3(1));
}

TEST_CASE(
    "three correspondences determine an affine map of the plane, exactly for small integers "
    "(S3-05)") {
  const std::array<glm::dvec2, 3> source{glm::dvec2(0, 0), glm::dvec2(4, 0), glm::dvec2(0, 2)};
  const std::array<glm::dvec2, 3> target{glm::dvec2(1, 1), glm::dvec2(5, 9), glm::dvec2(-1, 3)};
  const auto fit = affine_from_three_points(source, target);
  REQUIRE(fit);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(fit->matrix * glm::dvec4(source[i], 7, 1) == glm::dvec4(target[i], 7, 1));
  }
  CHECK(!affine_from_three_points({glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(3, 3)}, target));
  CHECK(!affine_from_three_points({glm::dvec2(0, 0), glm::dvec2(0, 0), glm::dvec2(3, 3)}, target));
}

TEST_CASE("the condition of three correspondences grows like 1/sin of the smallest angle (S3-05)") {
  const std::array<glm::dvec2, 3> target{glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};
  for (double angle : {1e-1, 1e-2, 1e-4, 1e-6}) {
    const SinCos a = sin_cos(angle);
    const auto fit = affine_from_three_points(
        {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(a.cos, a.sin)}, target);
    REQUIRE(fit);
    // The edges are (1, 0) and (cos, sin): their norm is at most 1.5, that of the inverse (1 +
    // cos)/sin, up to the sine.
    CHECK(fit->condition * a.sin > 1.5);
    CHECK(fit->condition * a.sin < 3);
    // The error grows with the condition.
    for (const glm::dvec2& p : {glm::dvec2(0, 0), glm::dvec2(1, 0)}) {
      CHECK(glm::length(glm::dvec2(fit->matrix * glm::dvec4(p, 0, 1)) - p) <=
            8 * u * fit->condition);
    }
  }
}

TEST_CASE(
    "four correspondences determine an affine map of space, which keeps parallels parallel "
    "(S3-05)") {
  Random random(36);
  for (int i = 0; i < 300; ++i) {
    WorldMap m;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column)
        m.at(row, column) = double(random.integer(-99, 99));
    }
    std::array<glm::dvec3, 4> source, target;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      source[corner] = {double(random.integer(-9, 9)), double(random.integer(-9, 9)),
                        double(random.integer(-9, 9))};
      target[corner] = to_glm(m * Point<World, double>(source[corner]));  // small integers: exact
    }
    const auto fit = affine_from_four_points(source, target);
    if (!fit) continue;  // the source points happened to be in a plane
    CAPTURE(i, fit->condition);
    // |entries| <= 99, |target edges| <= 99 * 27 * 2; the bound is of first order in the condition.
    CHECK(largest_difference(fit->matrix, m.columns) <= 16 * u * fit->condition * 99 * 54);
    const glm::dvec4 direction(1, 2, -3, 0);  // the same direction from two places
    CHECK((fit->matrix * direction).w == 0);
  }
  CHECK(!affine_from_four_points(
      {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(3, 4, 0)}, {}));
}

TEST_CASE(
    "a hundred nested transforms stay within their bound, and their inverses lead back (C-15)") {
  Random random(37);
  Transform<World, World> down, up;
  RationalMatrix exact = RationalMatrix::identity();
  glm::dmat4 sizes(1);  // product of |M_i|
  for (int level = 0; level < 100; ++level) {
    // Scales alternate between 2 and 1/2, so the product does not grow without bound.
    const double s = level % 2 == 0 ? 2 : 0.5;
    const Vector<World, double> to{random.between(-1, 1), random.between(-1, 1),
                                   random.between(-1, 1)};
    const double quarters = double(random.integer(0, 3)), thirds = double(random.integer(0, 2));
    const WorldMap m = translate<World>(to) * rotation({0, 0, 1}, quarters * 90) *
                       rotation({1, 1, 1}, thirds * 120) * scale<World>(s, s, s);
    down = down * m;
    const auto inverse = inverse_affine(m);
    REQUIRE(inverse);
    up = *inverse * up;
    exact = exact * test::exactly(m);
    glm::dmat4 absolute;
    for (int column = 0; column < 4; ++column) absolute[column] = glm::abs(m.columns[column]);
    sizes = sizes * absolute;
  }
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const Rational& entry = exact.at[std::size_t(row)][std::size_t(column)];
      CHECK(test::error_of(down.at(row, column), entry) <= gamma<double>(400) * sizes[column][row]);
    }
  }
  const Point<World, double> p{0.25, -0.5, 0.75};
  const Point<World, double> back = up * (down * p);
  CHECK(std::abs(back.x - p.x) <= 1e-6);
  CHECK(std::abs(back.y - p.y) <= 1e-6);
  CHECK(std::abs(back.z - p.z) <= 1e-6);
}

}  // namespace
}  // namespace glassbox
