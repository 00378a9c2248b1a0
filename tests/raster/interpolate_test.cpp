// Weights, depth and attributes, compared with exact rationals: the bounds that interpolate.h
// states, and the cases in which other formulas fail.
#include <algorithm>
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/formulas.h>
#include <glassbox/raster/interpolate.h>

#include "tests/raster/exact.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using namespace glassbox::test;

// The results of interpolate.h without rounding, for the setup's vertices and the fragment's edge
// values.
struct ExactFragment {
  std::array<Rational, 3> lambda, weights;
  Rational depth, inverse_w;
};

ExactFragment exact_fragment(const TriangleSetup& setup, const Coverage& pixel) {
  ExactFragment exact;
  for (std::size_t k = 0; k < 3; ++k) {
    exact.lambda[k] = Rational(pixel.edges[k]) / setup.double_area;
    exact.weights[k] = exact.lambda[k] * Rational(setup.inverse_w[k]);
    exact.depth += exact.lambda[k] * Rational(setup.depth[k]);
    exact.inverse_w += exact.weights[k];
  }
  for (Rational& weight : exact.weights) weight /= exact.inverse_w;
  return exact;
}

// The error in units of u and of the scale, as a number to print and compare.
double in_u(const Rational& error, const Rational& scale) {
  return scale == 0 ? (error == 0 ? 0.0 : INFINITY)
                    : double(Rational(abs_of(error) / scale)) * 0x1p24;
}

struct Worst {
  double lambda = 0, depth = 0, inverse_w = 0, weight = 0,
         attribute = 0;  // in units of u and of the scale
};

void compare(const TriangleSetup& setup, const Coverage& pixel, Worst& worst) {
  const Fragment fragment = interpolate(setup, pixel);
  const ExactFragment exact = exact_fragment(setup, pixel);
  const auto keep = [](double& most, const Rational& computed, const Rational& truth) {
    most = std::max(most, in_u(computed - truth, abs_of(truth)));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    keep(worst.lambda, Rational(fragment.lambda[k]), exact.lambda[k]);
    keep(worst.weight, Rational(fragment.weights[k]), exact.weights[k]);
  }
  keep(worst.depth, Rational(fragment.depth), exact.depth);
  keep(worst.inverse_w, Rational(fragment.inverse_w), exact.inverse_w);
  REQUIRE(fragment.depth >= setup.depth[0]);

  // An attribute with values of either sign, the same for each fragment.
  const std::array<float, 1> a0{3.7f}, a1{-1000.3f}, a2{0.1f};
  const Rational r0(a0[0]), r1(a1[0]), r2(a2[0]);
  const float computed = interpolate(a0, a1, a2, fragment.weights)[0];
  const Rational truth = exact.weights[0] * r0 + exact.weights[1] * r1 + exact.weights[2] * r2;
  // Its bound is absolute, 13 u spread + u |a|: 13 u in units of spread + |a| / 13.
  const Rational scale =
      exact.weights[1] * abs_of(r1 - r0) + exact.weights[2] * abs_of(r2 - r0) + abs_of(truth) / 13;
  worst.attribute = std::max(worst.attribute, in_u(Rational(computed) - truth, scale));
}

// One tenth of u exceeds all terms of higher order: (13 u)^2 is 1e-5 u.
constexpr double kHigherOrder = 0.1;

void require_within_bounds(const Worst& worst) {
  INFO("largest errors in u: lambda " << worst.lambda << ", depth " << worst.depth << ", 1/w "
                                      << worst.inverse_w << ", weight " << worst.weight
                                      << ", attribute " << worst.attribute);
  CHECK(worst.lambda <= 4 + kHigherOrder);
  CHECK(worst.depth <= 8 + kHigherOrder);
  CHECK(worst.inverse_w <= 7 + kHigherOrder);
  CHECK(worst.weight <= 10 + kHigherOrder);
  CHECK(worst.attribute <= 13 + kHigherOrder);
  CHECK(worst.lambda > 0.5);  // the errors do not all vanish
}

float random_depth(Random& random) {
  return float(random.scaled(0, 1, -30, 0));
}

std::array<float, 3> plain_interpolation(const std::array<float, 3>& a,
                                         const std::array<float, 3>& b,
                                         const std::array<float, 3>& c,
                                         const std::array<float, 3>& weights) {
  return interpolate(a, b, c, weights);
}

}  // namespace

TEST_CASE(
    "weights, depth and attributes are within the stated bounds of exact rationals (C-60, C-66)") {
  const std::uint64_t seed = 66;
  INFO("seed " << seed);
  Random random(seed);
  Worst worst;
  int pixels = 0;
  for (int i = 0; pixels < 6000; ++i) {
    std::array<ScreenVertex, 3> t;
    // Small triangles, triangles out to the guard band, and slivers.
    const int kind = i % 3;
    const std::int64_t reach = kind == 1 ? 1 << 23 : 4000;
    const std::int64_t x = random.integer(-reach, reach), y = random.integer(-reach, reach);
    for (ScreenVertex& v : t) {
      const auto inverse_w = float(random.scaled(1, 2, -20, 10));
      const bool sliver = kind == 2 && &v != &t[0];
      const auto near = [&](std::int64_t at) {
        return sliver ? at + random.integer(-20, 20) : random.integer(-reach, reach);
      };
      const std::int64_t at_x = near(x), at_y = near(y);
      v = screen_vertex(at_x, at_y, random_depth(random), inverse_w);
    }
    const auto setup = setup_triangle(t);
    if (!setup) continue;
    int wanted = 4;
    for_each_covered(*setup, {-4, -4, 12, 12}, [&](const Coverage& pixel) {
      if (wanted-- <= 0) return;
      ++pixels;
      compare(*setup, pixel, worst);
    });
  }
  require_within_bounds(worst);
}

TEST_CASE("a w from 1e-3 to 1e6 in one triangle costs less than 1e-3 of a texel of 1024 (C-66)") {
  const std::array<ScreenVertex, 3> t{screen_vertex(0, 0, 0.1f, 1e3f),
                                      screen_vertex(64 * 256, 300, 0.5f, 1.0f),
                                      screen_vertex(200, 64 * 256, 0.9f, 1e-6f)};
  const auto setup = setup_triangle(t);
  REQUIRE(setup);
  double worst = 0;
  for_each_covered(*setup, {0, 0, 64, 64}, [&](const Coverage& pixel) {
    const Fragment fragment = interpolate(*setup, pixel);
    const ExactFragment exact = exact_fragment(*setup, pixel);
    const float u = interpolate<1>({0.0f}, {1.0f}, {0.25f}, fragment.weights)[0];
    const Rational truth = exact.weights[1] + exact.weights[2] / 4;
    worst = std::max(worst, double(abs_of(Rational(u) - truth)) * 1024);
  });
  CAPTURE(worst);
  REQUIRE(worst < 1e-3);
}

TEST_CASE("what is equal at the vertices is exactly that everywhere") {
  Random random(7);
  for (int i = 0; i < 3000; ++i) {
    const float depth = random_depth(random), value = float(random.between(-1e6, 1e6));
    std::array<ScreenVertex, 3> t;
    for (ScreenVertex& v : t) {
      const std::int64_t x = random.integer(-2000, 4000), y = random.integer(-2000, 4000);
      v = screen_vertex(x, y, depth, float(random.between(1e-3, 1e3)));
    }
    const auto setup = setup_triangle(t);
    if (!setup) continue;
    const std::array<float, 3> a{value, -value, 1.0f};
    for_each_covered(*setup, {0, 0, 8, 8}, [&](const Coverage& pixel) {
      const Fragment fragment = interpolate(*setup, pixel);
      REQUIRE(fragment.depth == depth);
      REQUIRE(plain_interpolation(a, a, a, fragment.weights) == a);
    });
  }
}

TEST_CASE("two w equal are not three: the weights are those in space") {
  const std::array<float, 3> lambda{0.25f, 0.25f, 0.5f};
  for (const std::array<float, 3>& inverse_w :
       {std::array{1.0f, 1.0f, 0.5f}, std::array{0.5f, 1.0f, 1.0f}, std::array{1.0f, 0.5f, 1.0f}}) {
    const WeightsInSpace<float> weights = weights_in_space(lambda, inverse_w);
    const float q = lambda[0] * inverse_w[0] + lambda[1] * inverse_w[1] + lambda[2] * inverse_w[2];
    CHECK(weights.inverse_w == q);  // exact: powers of two
    CHECK(std::abs(weights.weight2 - lambda[2] * inverse_w[2] / q) <= 2 * 0x1p-24);
    CHECK(weights.weight2 != lambda[2]);
  }
  CHECK(weights_in_space<float>(lambda, {0.3f, 0.3f, 0.3f}).weight2 == lambda[2]);
}

TEST_CASE("all w equal: the weights are the screen's, and the distance is exact") {
  const auto setup =
      setup_triangle({screen_vertex(0, 0, 0.1f, 0.3f), screen_vertex(3000, 10, 0.2f, 0.3f),
                      screen_vertex(30, 3000, 0.7f, 0.3f)});
  REQUIRE(setup);
  for_each_covered(*setup, {0, 0, 12, 12}, [&](const Coverage& pixel) {
    const Fragment fragment = interpolate(*setup, pixel);
    REQUIRE(fragment.weights == fragment.lambda);
    REQUIRE(fragment.inverse_w == 0.3f);
  });
}

TEST_CASE("a fragment does not depend on winding or on where the vertices start (C-58)") {
  Random random(58);
  for (int i = 0; i < 2000; ++i) {
    std::array<ScreenVertex, 3> t;
    for (std::size_t k = 0; k < 3; ++k) {  // no two depths are equal, so one vertex is the nearest
      const std::int64_t x = random.integer(-2000, 4000), y = random.integer(-2000, 4000);
      const float z = float(k) * 0.25f + float(random.between(0.01, 0.2));
      t[k] = screen_vertex(x, y, z, float(random.between(0.1, 10)));
    }
    const auto setup = setup_triangle(t);
    if (!setup) continue;
    const PixelRect window{0, 0, 6, 6};
    for (const auto& order :
         {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}}) {
      const auto again = setup_triangle({t[order[0]], t[order[1]], t[order[2]]});
      REQUIRE(again);
      for_each_covered(*setup, window, [&](const Coverage& pixel) {
        const Fragment fragment = interpolate(*setup, pixel);
        Coverage same = pixel;
        for (std::size_t k = 0; k < 3; ++k) {
          same.edges[k] = again->edges[k].at(pixel.x * 256 + 128, pixel.y * 256 + 128);
        }
        const Fragment other = interpolate(*again, same);
        REQUIRE(other.depth == fragment.depth);
        REQUIRE(other.weights == fragment.weights);
        // The same triangle drawn again is not in front of the first.
        const DepthFormat format = DepthFormat::kFloat32;
        REQUIRE(!in_front(depth_code(format, other.depth), depth_code(format, fragment.depth)));
      });
    }
  }
}

TEST_CASE("a sliver's depth at its tip stays between those of its vertices (C-60)") {
  Random random(60);
  int pixels = 0;
  for (int i = 0; i < 600; ++i) {
    // Nearly edge-on: 4000 px long and at most 6/256 px wide, with the tip at a pixel centre or
    // just before it, on either side of a line through pixel centres.
    const std::int32_t dx = std::int32_t(random.integer(900000, 1024000));
    const std::int32_t dy = i % 3 == 0 ? dx : 0;
    const std::int32_t tip = 128 - std::int32_t(random.integer(0, 1));
    const float near = random_depth(random);
    const float far = near + float(random.unit()) * (1.0f - near);
    const std::array<ScreenVertex, 3> t{
        screen_vertex(tip, dy == 0 ? 128 : tip, i % 2 == 0 ? near : far, 1),
        screen_vertex(128 + dx, 128 + dy - random.integer(1, 3), i % 2 == 0 ? far : near, 0.01f),
        screen_vertex(128 + dx, 128 + dy + random.integer(1, 3), far, 0.01f)};
    const auto setup = setup_triangle(t);
    if (!setup) continue;
    const float most = *std::max_element(setup->depth.begin(), setup->depth.end());
    for_each_covered(*setup, {0, -4, 40, 8}, [&](const Coverage& pixel) {
      ++pixels;
      const Fragment fragment = interpolate(*setup, pixel);
      REQUIRE(fragment.depth >= setup->depth[0]);
      REQUIRE(Rational(fragment.depth) <= Rational(most) * (1 + gamma(8)));
      REQUIRE(depth_code(DepthFormat::kUnorm24, fragment.depth) <= 0xffffff);
    });
  }
  REQUIRE(pixels > 5000);
}

TEST_CASE("a floor to the horizon is exact; affine interpolation errs by the span law (C-65)") {
  // A strip 1024 px high whose far end is r times as far as its near end.
  for (const double r : {1.01, 2.0, 10.0, 100.0, 573.0}) {
    const float far = float(1.0 / r);
    const auto setup =
        setup_triangle({screen_vertex(0, 0, 0.5f, far), screen_vertex(4096, 0, 0.5f, far),
                        screen_vertex(0, 1024 * 256, 0.5f, 1.0f)});
    REQUIRE(setup);
    double exact_error = 0, affine_error = 0;
    const PixelRect column{0, 0, 1, 1024};
    for_each_covered(*setup, column, [&](const Coverage& pixel) {
      const Fragment fragment = interpolate(*setup, pixel);
      // v is 0 at the far edge and 1 at the near vertex, in any order of the setup.
      std::array<float, 3> v{};
      for (std::size_t k = 0; k < 3; ++k) v[k] = setup->order[k] == 2 ? 1.0f : 0.0f;
      const ExactFragment exact = exact_fragment(*setup, pixel);
      Rational truth = 0;
      for (std::size_t k = 0; k < 3; ++k) truth += exact.weights[k] * Rational(v[k]);
      const auto error = [&](const std::array<float, 3>& weights) {
        const float found = interpolate<1>({v[0]}, {v[1]}, {v[2]}, weights)[0];
        return std::abs(double(Rational(Rational(found) - truth)));
      };
      exact_error = std::max(exact_error, error(fragment.weights));
      affine_error = std::max(affine_error, error(fragment.lambda));
    });
    // The maximum is at t = sqrt(r)/(1 + sqrt(r)). The 1024 samples find it to within half a step
    // of its flat top; near the far end, for large r, the curve bends by less than r/1024^2 in a
    // step.
    const double law = (std::sqrt(r) - 1) / (std::sqrt(r) + 1);
    CAPTURE(r, exact_error * 0x1p24, affine_error, law);
    CHECK(exact_error <= 6 * 0x1p-24);
    CHECK(std::abs(affine_error - law) <= r / (1024.0 * 1024.0) + 1e-6);
  }
}

TEST_CASE(
    "coplanar triangles of different shape differ by at most 16 u, and the first drawn wins alike "
    "twice (C-57)") {
  // z = (3x + 5y + 700) / 2^19 with x and y in 1/256 px: exact in float at every vertex, so the
  // vertices are on exactly one plane.
  const auto on_plane = [](std::int64_t x, std::int64_t y) {
    return screen_vertex(x, y, float(3 * x + 5 * y + 700) * 0x1p-19f);
  };
  Random random(57);
  double worst = 0;
  int samples = 0, different = 0;
  const PixelRect window{0, 0, 40, 40};
  for (int i = 0; i < 60; ++i) {
    const auto triangle = [&] {
      const auto within = [&](std::int64_t left, std::int64_t right, std::int64_t top,
                              std::int64_t bottom) {
        const std::int64_t x = random.integer(left, right);
        return on_plane(x, random.integer(top, bottom));
      };
      return setup_triangle(
          {within(0, 9000, 0, 3000), within(0, 3000, 6000, 9000), within(6000, 9000, 0, 9000)});
    };
    const auto first = triangle(), second = triangle();
    if (!first || !second) continue;
    for_each_covered(*first, window, [&](const Coverage& pixel) {
      Coverage there{pixel.x, pixel.y, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        there.edges[k] = second->edges[k].at(pixel.x * 256 + 128, pixel.y * 256 + 128);
        if (there.edges[k] < 0) return;
      }
      const float a = interpolate(*first, pixel).depth, b = interpolate(*second, there).depth;
      ++samples;
      different += a != b;
      worst = std::max(worst, std::abs(double(a) - double(b)) / double(std::max(a, b)) * 0x1p24);
    });
  }
  CAPTURE(samples, different, worst);
  REQUIRE(samples > 1000);
  REQUIRE(different >
          0);  // coplanar triangles need not tie, and only in a tie does the first one drawn win
  REQUIRE(worst <= 16.1);  // 8 u for each of the two depths
}

TEST_CASE(
    "two planes that cross at a small angle are told apart wherever they are 16 u apart (C-59)") {
  Random random(59);
  for (const float slope :
       {0.2f, 0.004f, 0.00004f}) {  // depth over the width of the window: 90, 1 and 0.01 degrees
    const auto flat =
        setup_triangle({screen_vertex(-300, -200, 0.5f), screen_vertex(30000, 100, 0.5f),
                        screen_vertex(40, 32000, 0.5f)});
    const auto tilted = setup_triangle({screen_vertex(-200, -700, 0.5f - slope),
                                        screen_vertex(33000, 60, 0.5f + slope),
                                        screen_vertex(70, 31000, 0.5f - slope / 3)});
    REQUIRE(flat);
    REQUIRE(tilted);
    int decided = 0;
    for_each_covered(*tilted, {0, 0, 64, 64}, [&](const Coverage& pixel) {
      const Rational truth = exact_fragment(*tilted, pixel).depth;
      const Rational margin = abs_of(truth - Rational(1, 2));
      const float found = interpolate(*tilted, pixel).depth;
      if (margin <= gamma(8) * truth) return;
      ++decided;
      REQUIRE((found < 0.5f) == (truth < Rational(1, 2)));
    });
    CAPTURE(slope);
    REQUIRE(decided > 1000);
  }
}

TEST_CASE("a line's weights and depth are within the bounds of a triangle's") {
  Random random(9);
  double lambda = 0, depth = 0, weight = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::array<ScreenVertex, 2> ends{
        ScreenVertex{{0, 0, random_depth(random)}, float(random.between(0.001, 10))},
        ScreenVertex{{0, 0, random_depth(random)}, float(random.between(0.001, 10))}};
    LinePixel pixel;
    pixel.steps = random.integer(1, 1 << int(random.integer(1, 25)));
    pixel.step = random.integer(0, pixel.steps);
    const Fragment fragment = interpolate(ends, pixel);
    const std::array<Rational, 2> exact{Rational(pixel.steps - pixel.step) / pixel.steps,
                                        Rational(pixel.step) / pixel.steps};
    Rational z = 0, q = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      z += exact[k] * Rational(ends[k].position.z);
      q += exact[k] * Rational(ends[k].inverse_w);
    }
    REQUIRE(fragment.weights[0] == 0.0f);
    for (std::size_t k = 0; k < 2; ++k) {
      lambda = std::max(lambda, in_u(Rational(fragment.lambda[k + 1]) - exact[k], exact[k]));
      const Rational truth = exact[k] * Rational(ends[k].inverse_w) / q;
      weight = std::max(weight, in_u(Rational(fragment.weights[k + 1]) - truth, truth));
    }
    depth = std::max(depth, in_u(Rational(fragment.depth) - z, z));
  }
  CAPTURE(lambda, depth, weight);
  CHECK(lambda <= 4 + kHigherOrder);
  CHECK(depth <= 8 + kHigherOrder);
  CHECK(weight <= 10 + kHigherOrder);
}

TEST_CASE("varyings are interpolated member by member") {
  std::array<Varyings, 3> v;
  for (std::size_t k = 0; k < 3; ++k) {
    float next = float(k * 100);
    const auto fill = [&](auto& a) {
      for (float& x : a) x = next++;
    };
    fill(v[k].normal), fill(v[k].position), fill(v[k].diffuse), fill(v[k].specular);
    fill(v[k].color), fill(v[k].texcoord);
  }
  const Varyings at = interpolate(v, {0.25f, 0.25f, 0.5f});  // + 25 + 100
  float expected = 125;
  for (const float x : at.normal) CHECK(x == expected++);
  for (const float x : at.position) CHECK(x == expected++);
  for (const float x : at.diffuse) CHECK(x == expected++);
  for (const float x : at.specular) CHECK(x == expected++);
  for (const float x : at.color) CHECK(x == expected++);
  for (const float x : at.texcoord) CHECK(x == expected++);
}
