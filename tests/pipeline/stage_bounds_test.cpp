// The error bounds that the inspector prints beside numbers (generic bounds 1 to 3: transform,
// divide, screen), compared with rationals on random vertices and random matrices.
#include <algorithm>
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/base/rounding.h>
#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>

#include "tests/pipeline/rational.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using glassbox::Random;
using glassbox::test::Rational;

constexpr double kU = 0x1p-24;

Point<Object> random_vertex(Random& random, double size) {
  return {float(random.between(-size, size)), float(random.between(-size, size)),
          float(random.between(-size, size))};
}

template <class Target, class Source>
Transform<Target, Source> random_matrix(Random& random, double offset) {
  Transform<Target, Source> m;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      m.at(row, column) = random.between(-1, 1) * (column == 3 ? offset : 1);
    }
  }
  return m;
}

template <class T>
Rational exact_row(const Transform<Clip, Object, T>& m, int row, const Point<Object>& p) {
  return Rational(double(m.at(row, 0))) * Rational(p.x) +
         Rational(double(m.at(row, 1))) * Rational(p.y) +
         Rational(double(m.at(row, 2))) * Rational(p.z) + Rational(double(m.at(row, 3)));
}

// |M||x| for one row, rounded up by less than 2^-50 of its value.
template <class Target, class T>
double row_size(const Transform<Target, Object, T>& m, int row, const Point<Object>& p) {
  return (std::abs(double(m.at(row, 0)) * p.x) + std::abs(double(m.at(row, 1)) * p.y) +
          std::abs(double(m.at(row, 2)) * p.z) + std::abs(double(m.at(row, 3)))) *
         (1 + 0x1p-50);
}

}  // namespace

TEST_CASE("bounds 1 to 3 hold for every vertex, and stable vertices snap where the exact ones do") {
  const std::uint64_t seed = 51;
  INFO("seed " << seed);
  Random random(seed);
  const Viewport viewport{0, 0, 1366, 768};  // W/2 = 683 is exact
  const double half_width = 683, centre = 683;
  double transform_ratio = 0, divide_ratio = 0, screen_ratio = 0;
  int stable = 0, unstable = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto m = round_to_float(random_matrix<Clip, Object>(random, i % 2 == 0 ? 1 : 1000));
    const Point<Object> p = random_vertex(random, i % 3 == 0 ? 1000 : 1);
    const Point<Clip> clip = m * p;
    CAPTURE(i, p.x, p.y, p.z);

    // 1. Transform.
    const Rational x = exact_row(m, 0, p), w = exact_row(m, 3, p);
    const double x_bound = gamma<float>(4) * row_size(m, 0, p);
    const double w_bound = gamma<float>(4) * row_size(m, 3, p);
    const double x_error = test::error_of(clip.x, x), w_error = test::error_of(clip.w, w);
    REQUIRE(x_error <= x_bound);
    REQUIRE(w_error <= w_bound);
    transform_ratio = std::max(transform_ratio, x_error / x_bound);

    // 2. Divide: x^/w^ - x/w = (dx - (x/w) dw) / w^, and one rounding. Vertices beyond the guard
    // band are not divided.
    if (w == 0 || clip.w == 0 || std::abs(clip.x) > 100 * std::abs(clip.w)) continue;
    const NdcVertex ndc = divide(clip);
    const Rational exact_ndc = x / w;
    const double divide_bound =
        ((x_bound + std::abs(double(exact_ndc)) * w_bound) / std::abs(double(clip.w)) +
         kU * std::abs(double(clip.x) / double(clip.w))) *
        (1 + 0x1p-50);
    const double divide_error = test::error_of(ndc.position.x, exact_ndc);
    REQUIRE(divide_error <= divide_bound);
    divide_ratio = std::max(divide_ratio, divide_error / divide_bound);

    // 3. Screen.
    const ScreenVertex screen = to_screen(ndc, viewport);
    const Rational exact_screen = exact_ndc * Rational(half_width) + Rational(centre);
    const double screen_bound =
        (half_width * divide_bound +
         2 * kU * (std::abs(half_width * double(ndc.position.x)) + centre)) *
        (1 + 0x1p-50);
    const double screen_error = test::error_of(screen.position.x, exact_screen);
    REQUIRE(screen_error <= screen_bound);
    screen_ratio = std::max(screen_ratio, screen_error / screen_bound);

    // Snap: floor(256 X + 1/2). The boundaries are where 256 X + 1/2 is an integer. This sum is
    // exact in double: 24 bits and one below them.
    const double scaled = double(screen.position.x) * 256 + 0.5;
    const double to_boundary =
        std::min(scaled - std::floor(scaled), std::floor(scaled) + 1 - scaled) / 256;
    if (to_boundary > screen_bound) {
      ++stable;
      const Rational from_cell = exact_screen * 256 + Rational(1, 2) - Rational(std::floor(scaled));
      REQUIRE(from_cell >= 0);
      REQUIRE(from_cell < 1);
    } else {
      ++unstable;
    }
  }
  // The bounds are not much larger than the errors that occur, and there were vertices of both
  // kinds.
  CAPTURE(transform_ratio, divide_ratio, screen_ratio, stable, unstable);
  CHECK(transform_ratio > 0.25);
  CHECK(divide_ratio > 0.1);
  CHECK(screen_ratio > 0.1);
  CHECK(stable > 1000);
  CHECK(unstable > 100);
}

TEST_CASE("a product formed in double adds u |M||x|; formed in float it breaks that bound") {
  const std::uint64_t seed = 52;
  INFO("seed " << seed);
  Random random(seed);
  int float_product_breaks_it = 0;
  for (int i = 0; i < 5000; ++i) {
    // Two translations that cancel: a scene far from the origin with a camera beside it.
    auto clip_from_world = random_matrix<Clip, World>(random, 1);
    auto world_from_object = random_matrix<World, Object>(random, 1e5);
    world_from_object.at(3, 0) = world_from_object.at(3, 1) = world_from_object.at(3, 2) = 0;
    world_from_object.at(3, 3) = 1;
    for (int row = 0; row < 4; ++row) {
      clip_from_world.at(row, 3) = -(clip_from_world.at(row, 0) * world_from_object.at(0, 3) +
                                     clip_from_world.at(row, 1) * world_from_object.at(1, 3) +
                                     clip_from_world.at(row, 2) * world_from_object.at(2, 3)) +
                                   random.between(-1, 1);
    }
    const Transform<Clip, Object> composed = clip_from_world * world_from_object;
    const Point<Object> p = random_vertex(random, 1);
    const Point<Clip> in_double = round_to_float(composed) * p;
    const Point<Clip> in_float =
        (round_to_float(clip_from_world) * round_to_float(world_from_object)) * p;

    const test::RationalMatrix exact =
        test::exactly(clip_from_world) * test::exactly(world_from_object);
    const test::RationalVector q =
        exact * test::RationalVector{Rational(p.x), Rational(p.y), Rational(p.z), Rational(1)};
    // gamma_4 for the transform and u for the entries give gamma_5; the product in double adds an
    // error of gamma_4 in double.
    double product_size = 0;
    for (int k = 0; k < 4; ++k) {
      const double coordinate = k == 0 ? p.x : k == 1 ? p.y : k == 2 ? p.z : 1;
      for (int j = 0; j < 4; ++j) {
        product_size +=
            std::abs(clip_from_world.at(0, j) * world_from_object.at(j, k) * coordinate);
      }
    }
    const double bound =
        (gamma<float>(5) * row_size(composed, 0, p) + gamma<double>(4) * product_size) *
        (1 + 0x1p-20);
    CAPTURE(i);
    REQUIRE(test::error_of(in_double.x, q[0]) <= bound);
    float_product_breaks_it += test::error_of(in_float.x, q[0]) > bound;
  }
  CHECK(float_product_breaks_it > 4000);
}
