#include <tests/pipeline/cameras.h>
#include <tests/pipeline/roundoff.h>
#include <tests/support/catch.h>

#include <glm/gtc/matrix_transform.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/projection.h>

namespace glassbox {
namespace {

using test::LensCase;
using Real = boost::multiprecision::cpp_bin_float_50;

using test::u;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
using Projection = Transform<Clip, Eye>;

template <class T>
T must(const Result<T>& result) {
  INFO((result ? std::string() : result.error().message()));
  REQUIRE(result);
  return *result;
}

double depth_of(const Projection& m, double distance) {
  const Point<Clip, double> c = m * Point<Eye, double>(0, 0, -distance);
  return c.z / c.w;
}

// The largest distance in ulps between corresponding entries; they must be zero in the same places.
std::uint64_t largest_distance(const glm::dmat4& a, const glm::dmat4& b) {
  std::uint64_t largest = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      largest = std::max(largest, ulp_distance(a[column][row], b[column][row]));
    }
  }
  return largest;
}

bool has_negative_zero(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (m[column][row] == 0 && std::signbit(m[column][row])) return true;
    }
  }
  return false;
}

TEST_CASE("a right angle and powers of two give exact entries (S4-10, S4-12)") {
  const Projection m = must(perspective_degrees(90, 2, {1, 2}));
  CHECK(m == must(perspective(kHalfPi, 2, {1, 2})));
  CHECK(m.at(0, 0) == 0.5);
  CHECK(m.at(1, 1) == 1);
  CHECK(m.at(2, 2) == -2);
  CHECK(m.at(2, 3) == -2);
  CHECK(m.at(3, 2) == -1);
  CHECK(m.at(3, 3) == 0);

  const Projection o = must(orthographic({-8, 8, -4, 4}, {0, 16}));
  CHECK(o.at(0, 0) == 0.125);
  CHECK(o.at(1, 1) == 0.25);
  CHECK(o.at(2, 2) == -0.0625);
  CHECK(o.at(2, 3) == 0);
  CHECK(o.at(3, 3) == 1);
  for (const Projection& p :
       {m, o, must(frustum({-1, 1, -1, 1}, {1, 3})),
        must(perspective_degrees(60, 1, {1, kInfinite, DepthRange::kReversed}))}) {
    CHECK(!has_negative_zero(p.columns));
  }
}

TEST_CASE(
    "the near plane has depth exactly 0, the far one 1 to rounding, and the other way round "
    "reversed") {
  Random random(50);
  for (int i = 0; i < 3000; ++i) {
    const LensCase c = test::random_lens(random);
    const Projection standard =
        must(perspective_degrees(c.fovy_degrees, c.aspect, {c.near, c.far}));
    const Projection reversed =
        must(perspective_degrees(c.fovy_degrees, c.aspect, {c.near, c.far, DepthRange::kReversed}));
    CAPTURE(i, c.near, c.far);
    CHECK(depth_of(standard, c.near) == 0);
    CHECK(depth_of(reversed, c.far) == 0);
    // z is the difference of two numbers of about f^2/(f - n), each within 3 u, divided by w = f; 4
    // u for the rest.
    const double magnified = c.far / (c.far - c.near);
    CHECK(std::abs(depth_of(standard, c.far) - 1) <= (4 + 6 * magnified) * u);
    CHECK(std::abs(depth_of(reversed, c.near) - 1) <= (4 + 6 * magnified) * u);

    const Projection parallel = must(orthographic({-1, 1, -1, 1}, {c.near, c.far}));
    CHECK(std::abs((parallel * Point<Eye, double>(0, 0, -c.near)).z) <= 4 * u * magnified);
    CHECK(std::abs((parallel * Point<Eye, double>(0, 0, -c.far)).z - 1) <= 4 * u * magnified);
  }
}

TEST_CASE("every entry is within 4 ulps of its exact value, standard and reversed (oracle D)") {
  Random random(51);
  const Real pi = boost::multiprecision::acos(Real(-1));
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const LensCase c = test::random_lens(random);
    const double radians = radians_from_degrees(c.fovy_degrees);
    const Real n(c.near), f(c.far), aspect(c.aspect);
    for (const DepthRange range : {DepthRange::kStandard, DepthRange::kReversed}) {
      const bool standard = range == DepthRange::kStandard;
      const Projection by_radians = must(perspective(radians, c.aspect, {c.near, c.far, range}));
      const Projection by_degrees =
          must(perspective_degrees(c.fovy_degrees, c.aspect, {c.near, c.far, range}));
      const Real cot = 1 / boost::multiprecision::tan(Real(radians) / 2);
      const Real cot_degrees = 1 / boost::multiprecision::tan(Real(c.fovy_degrees) * pi / 360);
      const Window w{random.between(-2, -1), random.between(0, 1), random.between(-3, 1),
                     random.between(2, 5)};
      const Projection off_centre = must(frustum(w, {c.near, c.far, range}));
      const Projection parallel = must(orthographic(w, {c.near, c.far, range}));
      const Real width = Real(w.right) - w.left, height = Real(w.top) - w.bottom;
      const double errors[] = {
          error_in_ulps(by_radians.at(0, 0), Real(cot / aspect)),
          error_in_ulps(by_radians.at(1, 1), cot),
          error_in_ulps(by_degrees.at(0, 0), Real(cot_degrees / aspect)),
          error_in_ulps(by_degrees.at(1, 1), cot_degrees),
          error_in_ulps(by_degrees.at(2, 2), Real(standard ? -f / (f - n) : n / (f - n))),
          error_in_ulps(by_degrees.at(2, 3), Real((standard ? -1 : 1) * f * n / (f - n))),
          error_in_ulps(off_centre.at(0, 0), Real(2 * n / width)),
          error_in_ulps(off_centre.at(0, 2), Real((Real(w.right) + w.left) / width)),
          error_in_ulps(off_centre.at(1, 1), Real(2 * n / height)),
          error_in_ulps(off_centre.at(1, 2), Real((Real(w.top) + w.bottom) / height)),
          error_in_ulps(parallel.at(0, 0), Real(2 / width)),
          error_in_ulps(parallel.at(0, 3), Real(-(Real(w.right) + w.left) / width)),
          error_in_ulps(parallel.at(2, 2), Real((standard ? -1 : 1) / (f - n))),
          error_in_ulps(parallel.at(2, 3), Real(standard ? -n / (f - n) : f / (f - n)))};
      for (double error : errors) {
        worst = std::max(worst, error);
        CHECK(error < 4);
      }
    }
  }
  INFO("worst " << worst << " ulps");
  CHECK(worst < 3.2);
}

TEST_CASE(
    "10 000 random cameras agree with GLM's matrices, in both of its depth conventions (S4-12)") {
  Random random(52);
  std::uint64_t worst = 0, worst_gl = 0;
  for (int i = 0; i < 10000; ++i) {
    const LensCase c = test::random_lens(random);
    const double radians = radians_from_degrees(c.fovy_degrees);
    const Window w{random.between(-2, -1), random.between(0, 1), random.between(-3, 1),
                   random.between(2, 5)};
    const Projection ours[] = {must(perspective(radians, c.aspect, {c.near, c.far})),
                               must(frustum(w, {c.near, c.far})),
                               must(orthographic(w, {c.near, c.far}))};
    const glm::dmat4 zero_to_one[] = {
        glm::perspectiveRH_ZO(radians, c.aspect, c.near, c.far),
        glm::frustumRH_ZO(w.left, w.right, w.bottom, w.top, c.near, c.far),
        glm::orthoRH_ZO(w.left, w.right, w.bottom, w.top, c.near, c.far)};
    const glm::dmat4 minus_one_to_one[] = {
        glm::perspectiveRH_NO(radians, c.aspect, c.near, c.far),
        glm::frustumRH_NO(w.left, w.right, w.bottom, w.top, c.near, c.far),
        glm::orthoRH_NO(w.left, w.right, w.bottom, w.top, c.near, c.far)};
    for (int kind = 0; kind < 3; ++kind) {
      worst = std::max(worst, largest_distance(ours[kind].columns, zero_to_one[kind]));
      worst_gl = std::max(worst_gl, largest_distance((clip_gl_from_clip() * ours[kind]).columns,
                                                     minus_one_to_one[kind]));
    }
  }
  // Our entries are within 4 ulps. GLM divides by a tangent of the C library (1 ulp), with two more
  // roundings, and multiplies n by f.
  CHECK(worst <= 8);
  // In 2 z - w, entries near 2 minus 1 lose at most one bit, and so do parallel offsets -(f + n)/(f
  // - n).
  CHECK(worst_gl <= 12);
  const glm::dmat4 infinite = glm::infinitePerspective(1.0, 1.5, 0.25);
  CHECK(largest_distance((clip_gl_from_clip() * must(perspective(1.0, 1.5, {0.25}))).columns,
                         infinite) <= 8);
}

TEST_CASE(
    "perspective, frustum, T_pers and alpha/beta are one projection (S3-12, S3-14, S4-10, S4-12)") {
  Random random(53);
  for (int i = 0; i < 2000; ++i) {
    const LensCase c = test::random_lens(random);
    const double h = c.near * tan_half_degrees(c.fovy_degrees);
    const Projection p = must(perspective_degrees(c.fovy_degrees, 1, {c.near, c.far}));
    const Projection by_window = must(frustum({-h, h, -h, h}, {c.near, c.far}));
    const Projection watt = must(t_pers(h, c.near, c.far)) * eye_left_from_eye();
    const Projection slides =
        must(alpha_beta(c.fovy_degrees / 2, 1, c.near, c.far)) * eye_left_from_eye();
    CAPTURE(i, c.fovy_degrees, c.near, c.far);
    CHECK(slides == p);
    CHECK(largest_distance(watt.columns, p.columns) <= 8);  // h carries the tangent's 2.5 ulps
    CHECK(largest_distance(by_window.columns, p.columns) <= 8);
  }
}

TEST_CASE("T_pers is the slide's product, determinant and inverse (S4-10)") {
  const double h = 2, d = 1, f = 5;
  const auto m = must(t_pers(h, d, f));
  Transform<Clip, EyeLeft> box;
  box.at(2, 2) = f / (f - d);
  box.at(2, 3) = -d * f / (f - d);
  box.at(3, 2) = 1;
  box.at(3, 3) = 0;
  CHECK(m == box * scale<EyeLeft>(d / h, d / h, 1));
  CHECK(glm::determinant(m.columns) == d * d * d * f / (h * h * (f - d)));
  glm::dmat4 inverse(0);
  inverse[0][0] = inverse[1][1] = h / d;
  inverse[3][2] = 1;
  inverse[2][3] = -(f - d) / (d * f);
  inverse[3][3] = 1 / d;
  CHECK(inverse * m.columns == glm::dmat4(1));  // exact: powers of two, and 5/4 * 4/5 = 1
  // With our eye space, which looks along -z, the last rows are [0 0 -f/(f-d) -df/(f-d)] and [0 0
  // -1 0].
  const Projection ours = m * eye_left_from_eye();
  CHECK(ours.at(2, 2) == -1.25);
  CHECK(ours.at(2, 3) == -1.25);
  CHECK(ours.at(3, 2) == -1);
}

TEST_CASE("E13: the half-angle goes with the window's half-width") {
  // A window of width ResX = 4 at distance d = 2, whose right edge is at x = 2.
  const double res_x = 4, d = 2;
  const Point<EyeLeft, double> edge{res_x / 2, 0, d};
  const auto ndc_x = [&](double s) {
    const double half_angle = degrees_from_radians(arctan(s / d));
    const Point<Clip, double> c = must(alpha_beta(half_angle, 1, 1, 10)) * edge;
    return c.x / c.w;
  };
  CHECK(std::abs(ndc_x(res_x / 2) - 1) <= 8 * u);
  CHECK(std::abs(ndc_x(res_x) - 0.5) <=
        8 * u);  // the slide's s = ResX gives a picture of half the size
}

TEST_CASE("AR = ResX/ResY makes squares square (S3-14, E13)") {
  const double res_x = 640, res_y = 480;
  const auto m = must(alpha_beta(30, res_x / res_y, 1, 10));
  const Point<Clip, double> c = m * Point<EyeLeft, double>(1, 1, 5);
  CHECK(std::abs((c.x / c.w) * (res_x / 2) - (c.y / c.w) * (res_y / 2)) <= 8 * u * res_x);
}

TEST_CASE("simple perspective scales by d/z, and T_ort drops depth (S3-08, S4-06, S4-07)") {
  const Point<Clip, double> c = simple_perspective(2) * Point<EyeLeft, double>(3, -5, 8);
  CHECK(c.x / c.w == 0.75);
  CHECK(c.y / c.w == -1.25);
  CHECK(c.z / c.w == 2);
  CHECK(drop_depth() * Point<EyeLeft, double>(3, -5, 8) == Point<Clip, double>(3, -5, 0, 1));
  // The direction of the gaze, a point at infinity, is mapped to the middle of the picture (S4-06).
  const glm::dvec4 gaze = simple_perspective(2).columns * glm::dvec4(0, 0, 1, 0);
  CHECK(glm::dvec2(gaze) / gaze.w == glm::dvec2(0, 0));
}

TEST_CASE("fields of view next to 0 and 180 degrees work and report their condition (C-08)") {
  for (double fovy : {1e-6, 1e-3, 90.0, 179.0, 179.9999}) {
    const Projection m = must(perspective_degrees(fovy, 1, {1, 10}));
    const Real exact =
        1 / boost::multiprecision::tan(Real(fovy) * boost::multiprecision::acos(Real(-1)) / 360);
    CAPTURE(fovy);
    CHECK(error_in_ulps(m.at(1, 1), exact) < 4);
  }
  CHECK(fov_condition(1e-8) == 1);
  CHECK(fov_condition(kHalfPi) == kHalfPi);
  CHECK(fov_condition(radians_from_degrees(179.9999)) > 1e6);
}

TEST_CASE("fields of view of 0, 180 degrees and beyond, and NaN, are refused (C-08, C-03)") {
  for (double fovy : {0.0, -0.0, -45.0, 180.0, 200.0, 360.0, kInfinite, -kInfinite, std::nan("")}) {
    for (const auto& m : {perspective_degrees(fovy, 1, {1, 10}),
                          perspective(radians_from_degrees(fovy), 1, {1, 10})}) {
      CAPTURE(fovy);
      REQUIRE(!m);
      CHECK(m.error().place == "field of view");
      CHECK(m.error().remedy == "give a full vertical angle between 0 and 180 degrees, such as 45");
    }
  }
  CHECK(!perspective_degrees(1e-320, 1, {1, 10}));
  CHECK(!alpha_beta(90, 1, 1, 10));
  CHECK(!alpha_beta(0, 1, 1, 10));
  CHECK(!t_pers(0, 1, 10));
  CHECK(!t_pers(std::nan(""), 1, 10));
}

TEST_CASE("near <= 0, near = far, near > far and NaN are refused by name (C-09)") {
  const double nan = std::nan("");
  struct Case {
    double near, far;
    const char* place;
  };
  for (const Case& c : {Case{0, 10, "near plane"},
                        {-1, 10, "near plane"},
                        {nan, 10, "near plane"},
                        {kInfinite, kInfinite, "near plane"},
                        {1, 1, "far plane"},
                        {2, 1, "far plane"},
                        {1, nan, "far plane"},
                        {1, -5, "far plane"},
                        {1, 0, "far plane"}}) {
    for (const auto& m : {perspective_degrees(60, 1, {c.near, c.far}), frustum({}, {c.near, c.far}),
                          perspective_degrees(60, 1, {c.near, c.far, DepthRange::kReversed})}) {
      CAPTURE(c.near, c.far);
      REQUIRE(!m);
      CHECK(m.error().place == c.place);
      CHECK(!m.error().remedy.empty());
    }
  }
  CHECK(perspective_degrees(60, 1, {2, 1}).error().message() ==
        "far plane: its distance 1 is less than the near plane's 2; exchange the two planes; for "
        "depth 1 at the near plane choose the reversed range");
  CHECK(perspective_degrees(60, 1, {1e-30, 10}));
  CHECK(orthographic({}, {-5, 5}));
  for (const DepthPlanes& planes :
       {DepthPlanes{1, kInfinite}, {2, 1}, {1, 1}, {nan, 1}, {-kInfinite, 1}, {-1e308, 1e308}}) {
    CHECK(!orthographic({}, planes));
  }
}

TEST_CASE("windows without inside, and aspects that are no ratio, are refused (C-03)") {
  const double nan = std::nan("");
  for (const Window& w : {Window{1, 1, -1, 1},
                          {1, -1, -1, 1},
                          {-1, 1, 2, 1},
                          {nan, 1, -1, 1},
                          {-1, kInfinite, -1, 1},
                          {-1e308, 1e308, -1, 1}}) {
    CHECK(frustum(w, {1, 10}).error().place == "window");
    CHECK(orthographic(w, {1, 10}).error().place == "window");
  }
  for (double aspect : {0.0, -1.0, nan, kInfinite}) {
    CHECK(perspective_degrees(60, aspect, {1, 10}).error().place == "aspect ratio");
  }
}

TEST_CASE("an infinite far plane is exact: alpha = 1, beta = -near, reversed 0 and near (C-10)") {
  const Projection m = must(perspective_degrees(60, 1, {0.1}));
  CHECK(m.at(2, 2) == -1);
  CHECK(m.at(2, 3) == -0.1);
  CHECK(must(t_pers(1, 0.1, kInfinite)).at(2, 2) == 1);
  const Projection r = must(perspective_degrees(60, 1, {0.1, kInfinite, DepthRange::kReversed}));
  CHECK(r.at(2, 2) == 0);
  CHECK(r.at(2, 3) == 0.1);
}

TEST_CASE("depth is continuous as the far plane goes to infinity (C-10)") {
  const double n = 0.1;
  for (const DepthRange range : {DepthRange::kStandard, DepthRange::kReversed}) {
    const Projection infinite = must(perspective_degrees(60, 1, {n, kInfinite, range}));
    for (double ratio : {1e3, 1e6, 1e9, 1e15, 1e18, 1e300}) {
      const Projection finite = must(perspective_degrees(60, 1, {n, n * ratio, range}));
      for (double z = n; z < n * 1e3; z *= 3) {
        CAPTURE(ratio, z);
        // The two depths f/(f - n) (1 - n/z) and 1 - n/z differ by less than 1/(ratio - 1).
        CHECK(std::abs(depth_of(finite, z) - depth_of(infinite, z)) <= 1.01 / ratio + 4 * u);
      }
    }
  }
}

TEST_CASE(
    "reversed depth keeps 7 digits of distance in float, standard depth z/n times fewer (C-10, "
    "SPEC B.3)") {
  const double n = 0.1, f = 1e4;
  const auto relative_error = [&](const DepthRange range, double z) {
    const Projection m = must(perspective_degrees(60, 1, {n, f, range}));
    const float stored = float(depth_of(m, z));
    const double back = m.at(2, 3) / (stored + m.at(2, 2));  // z_eye = -B/(A + depth)
    return std::abs(back / z - 1);
  };
  double worst_standard = 0, worst_reversed = 0;
  for (double z = 900; z < 1100; z += 0.37) {
    worst_standard = std::max(worst_standard, relative_error(DepthRange::kStandard, z));
    worst_reversed = std::max(worst_reversed, relative_error(DepthRange::kReversed, z));
  }
  CHECK(worst_reversed <= 2 * 0x1p-24);
  CHECK(worst_standard > 1e-4);
  CHECK(worst_standard <= 0x1p-25 * 1100 / n * 1.1);
}

}  // namespace
}  // namespace glassbox
