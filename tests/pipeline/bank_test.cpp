// The true/false questions of the slides (S3.39-40) and the claims around them, checked as
// statements (S3-18).
#include <glassbox/base/random.h>
#include <tests/pipeline/roundoff.h>
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/projection.h>

namespace glassbox {
namespace {

using test::u;
using WorldMap = Transform<World, World>;
using EyePoint = Point<Eye, double>;

struct Image {
  double x = 0, y = 0, z = 0;
};

// The image of a point of eye space, with near 1, far 1000 and a field of view of 90 degrees.
Image image_of(const EyePoint& p) {
  static const Transform<Clip, Eye> projection = perspective_degrees(90, 1, {1, 1000}).value();
  const Point<Clip, double> c = projection * p;
  return {c.x / c.w, c.y / c.w, c.z / c.w};
}

EyePoint between(const EyePoint& a, const EyePoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

TEST_CASE(
    "true: parallel lines converge in perspective, to a point that only their direction decides "
    "(S3-18)") {
  const Vector<Eye, double> direction{1, 0.5, -2};
  const Image vanishing{1 / 2.0, 0.5 / 2.0, 0};
  double last_gap = 1e9;
  for (double t : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
    const Image a = image_of(EyePoint(0, 0, -2) + direction * t),
                b = image_of(EyePoint(3, -1, -4) + direction * t);
    const double gap = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
    CHECK(gap < last_gap / 3);
    CHECK(std::abs(a.x - vanishing.x) <= 4 / t);
    CHECK(std::abs(b.y - vanishing.y) <= 4 / t);
    last_gap = gap;
  }
  // Parallel lines that are perpendicular to the gaze stay parallel.
  const Image a0 = image_of({0, 0, -4}), a1 = image_of({2, 1, -4}), b0 = image_of({0, 1, -4}),
              b1 = image_of({2, 2, -4});
  CHECK((a1.x - a0.x) * (b1.y - b0.y) == (a1.y - a0.y) * (b1.x - b0.x));
}

TEST_CASE("false: parallel lines converge in parallel projection too (S3-07)") {
  const auto m = orthographic({-1, 1, -1, 1}, {0, 100}).value();
  const Vector<Eye, double> direction{1, 0.5, -2};
  for (double t : {1.0, 8.0, 64.0}) {
    const auto a = m * (EyePoint(0, 0, -2) + direction * t),
               b = m * (EyePoint(3, -1, -4) + direction * t);
    CHECK(a.x - b.x == -3);
    CHECK(a.y - b.y == 1);
  }
}

TEST_CASE("true: images shrink in proportion to distance (S3-18)") {
  for (double z : {1.0, 2.0, 4.0, 8.0}) {
    CHECK(image_of({1, 0, -z}).x - image_of({0, 0, -z}).x == 1 / z);
  }
}

TEST_CASE(
    "true: foreshortening is not uniform, so that midpoints do not stay midpoints (S3-18, S3-13)") {
  const EyePoint a{-1, 0, -2}, b{3, 0, -8};
  const Image middle = image_of(between(a, b, 0.5));
  const double image_middle = 0.5 * (image_of(a).x + image_of(b).x);
  CHECK(std::abs(middle.x - image_middle) > 0.1);
  // The image of the first half of the segment is more than half of the image of the segment.
  CHECK(std::abs(middle.x - image_of(a).x) > std::abs(image_of(b).x - middle.x));
}

TEST_CASE("true: lines and planes stay lines and planes, in depth as well (S3-07, S3-13)") {
  Random random(100);
  for (int i = 0; i < 500; ++i) {
    const EyePoint a{random.between(-5, 5), random.between(-5, 5), random.between(-50, -1)};
    const EyePoint b{random.between(-5, 5), random.between(-5, 5), random.between(-50, -1)};
    const Image ia = image_of(a), ib = image_of(b), ip = image_of(between(a, b, random.unit()));
    // Twice the area of the triangle of the three images, in the picture and in depth, with
    // coordinates up to 5, each within 8 u.
    CHECK(std::abs((ib.x - ia.x) * (ip.y - ia.y) - (ib.y - ia.y) * (ip.x - ia.x)) <=
          8 * u * 4 * 10 * 5);
    CHECK(std::abs((ib.x - ia.x) * (ip.z - ia.z) - (ib.z - ia.z) * (ip.x - ia.x)) <=
          8 * u * 4 * 10 * 5);
  }
}

TEST_CASE(
    "true: what lies behind the observer is mapped in front, which is why clipping comes first "
    "(S3-13)") {
  const auto m = perspective_degrees(90, 1, {1, 1000}).value();
  const Point<Clip, double> behind = m * EyePoint(1, 2, 4);
  CHECK(behind.w == -4);
  CHECK(behind.x / behind.w == -0.25);  // a legal position in the picture, upside down
  CHECK(behind.y / behind.w == -0.5);
  CHECK(behind.z / behind.w > 1);  // beyond the far plane, as if beyond infinity
}

TEST_CASE("true: z' = alpha + beta/z, 0 at hither and 1 at yon (S3-12)") {
  const double hither = 2, yon = 10;
  const double alpha = yon / (yon - hither), beta = yon * hither / (hither - yon);
  const auto m = alpha_beta(45, 1, hither, yon).value();
  for (double z : {2.0, 4.0, 5.0, 10.0}) {
    const Point<Clip, double> c = m * Point<EyeLeft, double>(0, 0, z);
    CHECK(std::abs(c.z / c.w - (alpha + beta / z)) <= 4 * u);
  }
}

TEST_CASE("E9: identity and inverses do not make a class closed, though translations are closed") {
  // T(a) T(b) = T(a + b).
  const Vector<World, double> a{1, 2, 3}, b{-5, 0.5, 8};
  CHECK(translate<World>(a) * translate<World>(b) == translate<World>(a + b));
  // {I, R(90), R(-90)} contains the identity and every inverse, but not R(90) R(90).
  const std::vector<WorldMap> set{WorldMap{}, rotate_degrees<World>({0, 0, 1}, 90).value(),
                                  rotate_degrees<World>({0, 0, 1}, -90).value()};
  const auto contains = [&](const WorldMap& m) {
    return std::count(set.begin(), set.end(), m) == 1;
  };
  for (const WorldMap& m : set) CHECK(contains(inverse_rigid(m)));
  CHECK(!contains(set[1] * set[1]));
}

TEST_CASE(
    "E10: affine maps are not combinations of linear ones: translation moves the origin and is not "
    "additive") {
  const WorldMap t = translate<World>({1, 0, 0});
  const Point<World, double> p{1, 2, 3}, q{4, 5, 6}, sum{5, 7, 9};
  CHECK(t * Point<World, double>(0, 0, 0) != Point<World, double>(0, 0, 0));
  CHECK((t * p).x + (t * q).x != (t * sum).x);
  // Rotation, scale and shear are additive, and no product of them moves the origin.
  const WorldMap linear = rotate_degrees<World>({0, 0, 1}, 90).value() * scale<World>(2, 3, 4) *
                          shear<World>(Axis::kX, Axis::kY, 5);
  CHECK((linear * p).x + (linear * q).x == (linear * sum).x);
  CHECK(linear * Point<World, double>(0, 0, 0) == Point<World, double>(0, 0, 0));
}

TEST_CASE(
    "true: the last row of an affine matrix is 0 0 0 1, products included, and w stays 1 (E10)") {
  Random random(101);
  WorldMap m;
  for (int i = 0; i < 50; ++i) {
    m = m * translate<World>({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    const Vector<World, double> axis{random.between(-1, 1), 1, 0};
    m = m * rotate_degrees<World>(axis, random.between(0, 360)).value();
    const double larger = random.between(0.5, 2), mirrored = random.between(-2, -0.5);
    m = m * scale<World>(larger, mirrored, 1) * shear<World>(Axis::kY, Axis::kX, random.unit());
    for (int column = 0; column < 4; ++column) CHECK(m.at(3, column) == (column == 3 ? 1 : 0));
    CHECK((m.columns * glm::dvec4{random.unit(), random.unit(), random.unit(), 1}).w == 1);
  }
  // The last entries of the columns are 0, those of the rows are not: they are the translation.
  CHECK(translate<World>({1, 2, 3}).at(0, 3) == 1);
}

TEST_CASE("true: affine maps keep parallels parallel; false: they keep angles (S3-05)") {
  const WorldMap m = shear<World>(Axis::kX, Axis::kY, 2) * scale<World>(2, 1, 1);
  const Vector<World, double> d{1, 3, 0};
  CHECK(m * (d * 4.0) == (m * d) * 4.0);
  const Vector<World, double> x = m * Vector<World, double>{1, 0, 0},
                              y = m * Vector<World, double>{0, 1, 0};
  CHECK(dot(x, y) != 0);
}

}  // namespace
}  // namespace glassbox
