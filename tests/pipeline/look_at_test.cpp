#include <tests/pipeline/cameras.h>
#include <tests/pipeline/rational.h>
#include <tests/pipeline/roundoff.h>
#include <tests/support/catch.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/pipeline/unit_vector.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace glassbox {
namespace {

using test::LookAtCase;
using test::Rational;

using test::u;
using EyeFromWorld = Transform<Eye, World>;
using WorldPoint = Point<World, double>;
using WorldVector = Vector<World, double>;

EyeFromWorld eye_from_world_of(const WorldPoint& eye, const WorldPoint& target,
                               const WorldVector& up) {
  const auto m = look_at(eye, target, up);
  REQUIRE(m);
  return *m;
}

// The largest differences of the rotations' entries and of the translations'.
struct Difference {
  double rotation = 0, translation = 0;
};
template <class A, class B>
Difference difference(const A& a, const B& b) {
  Difference d;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      d.rotation = std::max(d.rotation, std::abs(a[column][row] - b[column][row]));
    }
    d.translation = std::max(d.translation, std::abs(a[3][row] - b[3][row]));
  }
  return d;
}

TEST_CASE("a camera on the z axis that looks at the origin is a plain translation (S4-02)") {
  const EyeFromWorld m = eye_from_world_of({0, 0, 1}, {0, 0, 0}, {0, 1, 0});
  CHECK(m == EyeFromWorld(translate<World>({0, 0, -1}).columns));
}

TEST_CASE("all 24 axis-aligned cameras are exact, without -0 (S4-03)") {
  const WorldVector axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  int cameras = 0;
  for (const WorldVector& gaze : axes) {
    for (const WorldVector& up : axes) {
      if (dot(gaze, up) != 0) continue;
      ++cameras;
      const WorldPoint eye{3, -5, 7};
      for (const auto& m : {look_at(eye, eye + gaze * 9.0, up * 0.3),
                            look_at_axis_angle(eye, eye + gaze * 9.0, up * 0.3)}) {
        REQUIRE(m);
        const WorldVector right = cross(gaze, up);
        const WorldVector rows[] = {right, up, -gaze};
        for (int row = 0; row < 3; ++row) {
          CAPTURE(cameras, row);
          CHECK(m->at(row, 0) == rows[row].x);
          CHECK(m->at(row, 1) == rows[row].y);
          CHECK(m->at(row, 2) == rows[row].z);
          CHECK(m->at(row, 3) == -(rows[row].x * 3 + rows[row].y * -5 + rows[row].z * 7));
        }
        for (int row = 0; row < 4; ++row) {
          for (int column = 0; column < 4; ++column) {
            CHECK(!(m->at(row, column) == 0 && std::signbit(m->at(row, column))));
          }
        }
      }
    }
  }
  CHECK(cameras == 24);
}

TEST_CASE(
    "the view matrix is a rotation that carries eye, target and up where they belong (S4-03, "
    "S4-04)") {
  Random random(40);
  for (int i = 0; i < 2000; ++i) {
    const LookAtCase c = test::random_look_at(random);
    const EyeFromWorld m = eye_from_world_of(c.eye, c.target, c.up);
    CAPTURE(i, c.up_sine);
    const glm::dmat3 rotation(m.columns);
    CHECK(orthogonality_error(rotation) <= (8 + 8 / c.up_sine) * u);
    CHECK(glm::determinant(rotation) > 0.5);
    const double reach =
        test::length(c.target - WorldPoint(0, 0, 0)) + test::length(c.eye - WorldPoint(0, 0, 0));
    const double bound = (16 + 16 / c.up_sine) * u * reach;
    const Point<Eye, double> eye = m * c.eye, target = m * c.target;
    CHECK(std::abs(eye.x) + std::abs(eye.y) + std::abs(eye.z) <= 3 * bound);
    CHECK(std::abs(target.x) <= bound);
    CHECK(std::abs(target.y) <= bound);
    CHECK(std::abs(target.z + test::length(c.target - c.eye)) <= bound);
    const Vector<Eye, double> up = m * c.up;
    CHECK(std::abs(up.x) <= (16 + 16 / c.up_sine) * u);
    CHECK(up.y > 0);
  }
}

TEST_CASE(
    "UVN of rational cameras is within (8 + 4/sine) u of the exact matrix (S4-03, oracle Q)") {
  Random random(41);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const test::PythagoreanRotation r = test::pythagorean_rotation(random);
    const auto axis = [&](std::size_t row, double length) {
      return WorldVector{double(r.numerator[row][0]) * length, double(r.numerator[row][1]) * length,
                         double(r.numerator[row][2]) * length};
    };
    const WorldPoint eye{double(random.integer(-99, 99)), double(random.integer(-99, 99)),
                         double(random.integer(-99, 99))};
    // The gaze is opposite to the third row, up is in the plane of the second and third rows: all
    // are integers, nothing is rounded.
    const double tilt = double(random.integer(-3, 3));
    const WorldVector up = axis(1, 1) + axis(2, tilt);
    const EyeFromWorld m = eye_from_world_of(eye, eye + axis(2, -double(random.integer(1, 9))), up);
    const test::RationalMatrix exact = test::exactly(r);
    const double sine = 1 / std::sqrt(1 + tilt * tilt);
    CAPTURE(i, tilt);
    for (int row = 0; row < 3; ++row) {
      Rational shift = 0;
      for (int column = 0; column < 3; ++column) {
        const Rational& entry = exact.at[std::size_t(row)][std::size_t(column)];
        shift -= entry * Rational(column == 0 ? eye.x : column == 1 ? eye.y : eye.z);
        const double error = test::error_of(m.at(row, column), entry) / u;
        worst = std::max(worst, error / (8 + 4 / sine));
        CHECK(error <= 8 + 4 / sine);
      }
      // |eye| <= 99 sqrt(3); gamma_3 is for the sum.
      CHECK(test::error_of(m.at(row, 3), shift) <= (11 + 4 / sine) * u * 172);
    }
  }
  INFO("worst " << worst << " of the bound");
  CHECK(worst > 0.05);  // the bound is not far too large
}

TEST_CASE("both constructions agree within their bounds (S3-16)") {
  Random random(42);
  for (int i = 0; i < 5000; ++i) {
    const LookAtCase c = test::random_look_at(random);
    const auto turned = look_at_axis_angle(c.eye, c.target, c.up);
    REQUIRE(turned);
    const Difference d =
        difference(turned->columns, eye_from_world_of(c.eye, c.target, c.up).columns);
    CAPTURE(i, c.up_sine);
    CHECK(d.rotation <= (32 + 16 / c.up_sine) * u);
    CHECK(d.translation <=
          (48 + 16 / c.up_sine) * u * test::length(c.eye - WorldPoint(0, 0, 0)) * 2);
  }
}

TEST_CASE(
    "looking straight back, and nearly so, the axis-angle construction keeps its digits (C-05, "
    "E8)") {
  const WorldPoint eye{0, 0, 0};
  const WorldVector up{0.25, 1, 0};
  for (double off : {0.0, 1e-300, 1e-200, 1e-100, 1e-17, 1e-9, 1e-6, -1e-6, -1e-300}) {
    const WorldPoint target{off, -2 * off, 1};
    const auto turned = look_at_axis_angle(eye, target, up);
    REQUIRE(turned);
    CAPTURE(off);
    CHECK(difference(turned->columns, eye_from_world_of(eye, target, up).columns).rotation <=
          64 * u);
    const Point<Eye, double> image = *turned * target;
    CHECK(std::abs(image.x) <= 8 * u);
    CHECK(std::abs(image.y) <= 8 * u);
    CHECK(std::abs(image.z + test::length(target - eye)) <= 8 * u);
  }
}

TEST_CASE("E8: the slide's cosine a.z in place of v.z turns by the wrong angle") {
  // The axis a is perpendicular to z, so a.z is 0 and every camera would turn by 90 degrees.
  const WorldVector v = *unit(WorldVector{3, 1, -2});
  const WorldVector minus_z{0, 0, -1};
  const WorldVector across = cross(v, minus_z);
  const WorldVector a = *unit(across);
  CHECK(dot(a, minus_z) == 0);
  const auto wrong = rotate_degrees<World>(a, 90);
  REQUIRE(wrong);
  CHECK((*wrong * v).z > -0.9);
  const double right_angle_degrees = std::atan2(test::length(across), dot(v, minus_z)) * 180 / M_PI;
  const auto right = rotate_degrees<World>(a, right_angle_degrees);
  REQUIRE(right);
  CHECK(std::abs((*right * v).z + 1) <= 16 * u);
}

// The construction of S3.37 to the letter: rotate the gaze to +z, then up into the upper half of
// the yz plane, both by proper rotations.
Transform<EyeLeft, World> slide_37(const WorldPoint& eye, const WorldPoint& target,
                                   const WorldVector& up) {
  const WorldVector v = *unit(target - eye);
  const WorldVector across = cross(v, WorldVector{0, 0, 1});
  const double degrees = std::atan2(test::length(across), v.z) * 180 / M_PI;
  const auto turn = rotate_degrees<World>(across, degrees);
  REQUIRE(turn);
  const WorldVector turned_up = *turn * up;
  const auto roll = rotate_degrees<EyeLeft, World>(
      WorldVector{0, 0, 1}, std::atan2(turned_up.x, turned_up.y) * 180 / M_PI);
  REQUIRE(roll);
  return *roll * *turn * translate<World>(WorldPoint(0, 0, 0) - eye);
}

// Twice the signed area of the image of three points: positive if counter-clockwise with y up.
template <class ClipFromWorld>
double image_turn(const ClipFromWorld& m, const std::array<WorldPoint, 3>& p) {
  std::array<std::array<double, 2>, 3> at{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point<Clip, double> c = m * p[i];
    REQUIRE(c.w > 0);
    at[i] = {c.x / c.w, c.y / c.w};
  }
  return (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) -
         (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
}

TEST_CASE("E7: rotating the gaze to +z mirrors the picture of an F, unless x is flipped (C-06)") {
  // The foot of the F, its top and the end of its upper arm: clockwise for an observer in front of
  // it who reads an F.
  const std::array<WorldPoint, 3> glyph{WorldPoint(0, 0, 0), WorldPoint(0, 2, 0),
                                        WorldPoint(1, 2, 0)};
  const WorldPoint eye{1, 2, 6}, target{0.5, 1, 0};
  const WorldVector up{0, 1, 0};
  const auto lens = alpha_beta(30, 1, 1, 100);
  const auto ours = perspective_degrees(60, 1, {1, 100});
  REQUIRE(lens);
  REQUIRE(ours);

  const auto right = *ours * eye_from_world_of(eye, target, up);
  const auto wrong = *lens * slide_37(eye, target, up);
  CHECK(image_turn(right, glyph) < 0);
  CHECK(image_turn(wrong, glyph) > 0);

  const Transform<Clip, World> flipped = scale<Clip>(-1, 1, 1) * wrong;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      // Entries up to 7; the angle of the C library goes to degrees and back.
      CHECK(std::abs(flipped.at(row, column) - right.at(row, column)) <= 200 * u);
    }
  }
  const auto turned = look_at_axis_angle(eye, target, up);
  REQUIRE(turned);
  CHECK(image_turn(*ours * *turned, glyph) < 0);
}

TEST_CASE(
    "up at a small angle to the gaze costs 2u over its sine, up along the gaze is refused (C-01)") {
  const WorldPoint eye{1, 2, 3};
  const WorldVector gaze{3, -2, 6};  // |gaze| = 7
  const WorldPoint target = eye + gaze;
  const WorldVector across{
      6, 3, -2};  // perpendicular, length 7; the third axis is their cross product over 7
  for (double e : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    const WorldVector up = gaze + across * e;
    const EyeFromWorld m = eye_from_world_of(eye, target, up);
    // The exact V is up minus its part along the gaze, normalized; in long double, whose unit
    // roundoff is u/2048.
    const long double k =
        ((long double)(up.x) * 3 - (long double)(up.y) * 2 + (long double)(up.z) * 6) / 49;
    const long double vx = up.x - k * 3, vy = up.y + k * 2, vz = up.z - k * 6;
    const long double size = std::sqrt(vx * vx + vy * vy + vz * vz);
    const double bound =
        (8 + 4 / e) * u + 16 * double(std::numeric_limits<long double>::epsilon()) / e;
    CAPTURE(e);
    CHECK(std::abs(double(m.at(1, 0) - vx / size)) <= bound);
    CHECK(std::abs(double(m.at(1, 1) - vy / size)) <= bound);
    CHECK(std::abs(double(m.at(1, 2) - vz / size)) <= bound);
  }
  for (const WorldVector& up : {gaze, -gaze, gaze * 1e-30, gaze + across * 1e-7}) {
    for (const auto& m : {look_at(eye, target, up), look_at_axis_angle(eye, target, up)}) {
      REQUIRE(!m);
      CHECK(m.error().place == "up");
      CHECK(m.error().cause.find("along the view") != std::string::npos);
      CHECK(m.error().remedy == "choose another, such as 0,1,0");
    }
  }
  CHECK(look_at({0, 5, 0}, {0, 0, 0}, {0, 1, 0}).error().message() ==
        "up: (0, 1, 0) points along the view, so that the picture's roll is undefined; choose "
        "another, such as 0,0,1");
}

TEST_CASE("the suggested up always works (C-01)") {
  Random random(43);
  for (int i = 0; i < 500; ++i) {
    WorldVector gaze{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (i % 3 == 0) gaze = {double(random.integer(-1, 1)), double(random.integer(-1, 1)), 1};
    const auto refused = camera_pose(WorldPoint{0, 0, 0}, gaze, gaze);
    REQUIRE(!refused);
    const std::string& remedy = refused.error().remedy;
    const std::string numbers = remedy.substr(remedy.rfind(' ') + 1);
    const WorldVector up{double(numbers[0] - '0'), double(numbers[2] - '0'),
                         double(numbers[4] - '0')};
    CHECK(camera_pose(WorldPoint{0, 0, 0}, gaze, up));
  }
}

TEST_CASE("an eye that is its own target is refused (C-02)") {
  for (const auto& m : {look_at({1, 2, 3}, {1, 2, 3}, {0, 1, 0}),
                        look_at_axis_angle({1, 2, 3}, {1, 2, 3}, {0, 1, 0})}) {
    REQUIRE(!m);
    CHECK(m.error().message() ==
          "look-at: (1, 2, 3) is the eye itself, so that there is no direction of view; move one "
          "of the two");
  }
}

TEST_CASE("zero, NaN, infinite and subnormal ups, eyes and targets are refused (C-03)") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const double tiny = std::numeric_limits<double>::denorm_min();
  const WorldPoint eye{0, 0, 5}, target{0, 0, 0};
  for (const WorldVector& up :
       {WorldVector{0, 0, 0}, {nan, 1, 0}, {0, inf, 0}, {0, tiny, 0}, {0, -inf, nan}}) {
    CHECK(!look_at(eye, target, up));
    CHECK(!look_at_axis_angle(eye, target, up));
  }
  for (double bad : {nan, inf, -inf}) {
    CHECK(!look_at({bad, 0, 0}, target, {0, 1, 0}));
    CHECK(!look_at(eye, {0, bad, 0}, {0, 1, 0}));
    CHECK(!camera_pose(eye, WorldVector{0, 0, bad}, {0, 1, 0}));
    CHECK(!look_at_axis_angle({0, 0, bad}, target, {0, 1, 0}));
  }
}

TEST_CASE(
    "lengths of gaze and up do not matter, by powers of two not even in the last bit (C-03)") {
  const WorldVector gaze{1, -2, 0.5}, up{0.1, 1, 0.3};
  const auto plain = camera_pose(WorldPoint{1, 2, 3}, gaze, up);
  REQUIRE(plain);
  for (int e : {-1000, -500, -30, 30, 500, 1000}) {
    const auto scaled =
        camera_pose(WorldPoint{1, 2, 3}, gaze * std::ldexp(1, e), up * std::ldexp(1, -e));
    REQUIRE(scaled);
    CHECK(*scaled == *plain);
  }
}

#if defined(__SSE2__)
// While it exists, subnormal numbers are zero: sets the two modes of the processor for that.
class FlushToZero {
public:
  FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
  ~FlushToZero() { _mm_setcsr(before_); }
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

private:
  unsigned before_;
};

TEST_CASE(
    "what is accepted gives the same bytes where subnormal numbers are flushed to zero (C-03)") {
  Random random(46);
  for (int i = 0; i < 500; ++i) {
    const LookAtCase c = test::random_look_at(random);
    const test::LensCase lens = test::random_lens(random);
    // The length of up ranges from subnormal to ordinary.
    const WorldVector up = c.up * std::ldexp(1.0, -int(random.integer(0, 1080)));
    const auto plain = look_at(c.eye, c.target, up);
    const auto plain_lens =
        perspective_degrees(lens.fovy_degrees, lens.aspect, {lens.near, lens.far});
    const FlushToZero mode;
    const auto flushed = look_at(c.eye, c.target, up);
    const auto flushed_lens =
        perspective_degrees(lens.fovy_degrees, lens.aspect, {lens.near, lens.far});
    CAPTURE(i, c.up_sine);
    CHECK(bool(plain) == bool(flushed));
    if (plain && flushed) CHECK(*plain == *flushed);
    CHECK(plain_lens.value() == flushed_lens.value());
  }
}
#endif

TEST_CASE("a camera far from the origin sees near things as exactly as one at the origin (C-13)") {
  // An object at the offset and an eye beside it. The transforms are composed in double, rounded
  // once and then applied in float. The naive order, world positions in float times a float view
  // matrix, is the wrong variant.
  Random random(44);
  for (double offset : {1e2, 1e4, 1e6, 1e8}) {
    double worst = 0, naive_worst = 0;
    for (int i = 0; i < 200; ++i) {
      const WorldVector place{offset, -offset, offset * 0.5};
      const WorldPoint eye = WorldPoint{3, 4, 5} + place;
      const EyeFromWorld eye_from_world =
          eye_from_world_of(eye, WorldPoint{0, 0, 0} + place, {0, 1, 0});
      const Transform<World, Object> world_from_object = translate<World, Object>(place);
      const Transform<Eye, Object, float> eye_from_object =
          round_to_float(eye_from_world * world_from_object);
      const Point<Object> p{float(random.between(-1, 1)), float(random.between(-1, 1)),
                            float(random.between(-1, 1))};
      const Point<Eye> image = eye_from_object * p;

      const Transform<Eye, World, float> eye_from_world_float = round_to_float(eye_from_world);
      const Point<World> world = round_to_float(world_from_object) * p;
      const Point<Eye> naive = eye_from_world_float * world;

      // Exact for the rotation as it was rounded: the offset is subtracted first.
      const Vector<World, double> relative{double(p.x) - 3, double(p.y) - 4, double(p.z) - 5};
      const Vector<Eye, double> exact = eye_from_world * relative;
      for (auto [value, bad, right] : {std::array<double, 3>{image.x, naive.x, exact.x},
                                       {image.y, naive.y, exact.y},
                                       {image.z, naive.z, exact.z}}) {
        worst = std::max(worst, std::abs(value - right));
        naive_worst = std::max(naive_worst, std::abs(bad - right));
      }
    }
    CAPTURE(offset, worst, naive_worst);
    CHECK(worst <=
          2e-6);  // |image| <= 9, so 4 u |M||x| in float is 2e-6, and 1e8 in double adds 1e-7
    if (offset >= 1e6) CHECK(naive_worst > 1e-2);
  }
}

TEST_CASE("a cube of one metre on a planet keeps its shape (C-14)") {
  const WorldVector place{6.378e6, 0, 0};
  const EyeFromWorld eye_from_world =
      eye_from_world_of(WorldPoint{0, 0, 2} + place, WorldPoint{0, 0, 0} + place, {0, 1, 0});
  const auto m = round_to_float(eye_from_world * translate<World, Object>(place));
  for (int corner = 0; corner < 8; ++corner) {
    const Point<Object> p{(corner & 1) != 0 ? 0.5f : -0.5f, (corner & 2) != 0 ? 0.5f : -0.5f,
                          (corner & 4) != 0 ? 0.5f : -0.5f};
    CHECK(m * p == Point<Eye>(p.x, p.y, p.z - 2));
  }
  // In world space floats are half a metre apart on the planet: distinct corners coincide.
  CHECK(float(6.378e6 + 0.4) == float(6.378e6 + 0.5));
}

TEST_CASE("10 000 random cameras agree with GLM's lookAt (S4-12)") {
  Random random(45);
  for (int i = 0; i < 10000; ++i) {
    const LookAtCase c = test::random_look_at(random);
    const glm::dmat4 theirs = glm::lookAt(to_glm(c.eye), to_glm(c.target), to_glm(c.up));
    const Difference d = difference(eye_from_world_of(c.eye, c.target, c.up).columns, theirs);
    // Each is within (8 + 4/sine) u of the exact matrix, and GLM's has one more inverse square
    // root: 2.5 times that.
    const double bound = (24 + 12 / c.up_sine) * u;
    CAPTURE(i, c.up_sine);
    CHECK(d.rotation <= bound);
    CHECK(d.translation <=
          (bound + 6 * u) * 3 * 100);  // times |eye|'s components, each at most 100
  }
}

}  // namespace
}  // namespace glassbox
