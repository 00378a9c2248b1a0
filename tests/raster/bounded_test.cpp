// Numbers with error bounds, compared with arithmetic of 320 bits: sums, products, quotients and
// roots of all magnitudes, comparisons, and lighting.
#include <glassbox/raster/bounded_formulas.h>

#include <bit>

#include <glassbox/base/random.h>
#include <glassbox/raster/light_formulas.h>

#include "tests/raster/exact_formulas.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using bounded::Bounded;
using in_full::Big;

// A computed number with its error bound, and the exact number; they differ by at most the bound.
struct Pair {
  Bounded computed;
  Big exact;
};

// Numbers of all magnitudes. Some have no error, some an error larger than themselves, and for some
// the exact number is at an end of the range.
Pair random_pair(Random& random) {
  const float sizes[] = {1.0f, 1e-3f, 1e3f, 1e-20f, 1e20f, 0x1p-140f};
  const float share = float(random.between(-1, 1));
  float value = share * sizes[random.integer(0, 5)];
  if (random.unit() < 0.1) value = float(random.integer(-2, 2));
  const double shares[] = {0, 0x1p-24, 1e-5, 0.3, 1.5};
  const double bound = std::abs(double(value)) * shares[random.integer(0, 4)];
  const double off = random.unit() < 0.3 ? (random.unit() < 0.5 ? -1 : 1) : random.between(-1, 1);
  return {{value, bound}, Big(value) + Big(bound) * Big(off)};
}

double excess(const Bounded& computed, const Big& exact) {
  if (!computed.is_bounded()) return 0;
  return double(abs(Big(computed.value) - exact) - Big(computed.bound));
}

}  // namespace

TEST_CASE("a number with a bound is the run's number, and within its bound of the exact one") {
  Random random(19);
  int useful = 0;
  for (int i = 0; i < 150'000; ++i) {
    const Pair a = random_pair(random), b = random_pair(random);
    CAPTURE(i, a.computed.value, a.computed.bound, b.computed.value, b.computed.bound);
    const Bounded sum = a.computed + b.computed, product = a.computed * b.computed;
    REQUIRE(std::bit_cast<std::uint32_t>(sum.value) ==
            std::bit_cast<std::uint32_t>(a.computed.value + b.computed.value));
    REQUIRE(excess(sum, a.exact + b.exact) <= 0);
    REQUIRE(excess(a.computed - b.computed, a.exact - b.exact) <= 0);
    REQUIRE(excess(product, a.exact * b.exact) <= 0);
    if (b.exact != 0) {
      const Bounded quotient = a.computed / b.computed;
      REQUIRE(excess(quotient, a.exact / b.exact) <= 0);
      useful += quotient.is_bounded();
    }
    if (a.exact >= 0 && a.computed.value >= 0) {
      REQUIRE(excess(bounded::sqrt(a.computed), sqrt(a.exact)) <= 0);
    }
    const bounded::UncertainBool less = a.computed < b.computed;
    if (less.is_sure) REQUIRE(less.holds == (a.exact < b.exact));
    REQUIRE(excess(bounded::least(a.computed, b.computed), in_full::least(a.exact, b.exact)) <= 0);
    REQUIRE(excess(bounded::clamped(a.computed, Bounded(-0.5f), Bounded(0.5f)),
                   in_full::clamped(a.exact, Big(-0.5), Big(0.5))) <= 0);
  }
  CHECK(useful > 75'000);
}

TEST_CASE("what rounds nothing costs nothing") {
  const Bounded third(1.0f / 3.0f, 1e-9);
  CHECK((third * 1.0f).bound <= 1e-9 * (1 + 0x1p-48));
  CHECK((Bounded(3.0f) + 5.0f).bound == 0);
  CHECK((Bounded(3.0f) * 0.5f).bound == 0);
  CHECK((Bounded(3.0f) / 4.0f).bound == 0);
  CHECK(bounded::sqrt(Bounded(9.0f)).bound == 0);
  CHECK((third - third).bound > 0);  // the two operands are not known to be the same number
}

TEST_CASE("a choice that is not sure stands for both") {
  const Bounded a(1.0f, 0.1), b(1.05f, 0.1);
  const Bounded chosen = bounded::select(a < b, Bounded(2.0f), Bounded(7.0f));
  CHECK(chosen.value == 2);
  CHECK(chosen.bound >= 5);
  CHECK(bounded::select(a < Bounded(3.0f), Bounded(2.0f), Bounded(7.0f)).bound == 0);
  CHECK_FALSE(bounded::none(b < a));  // it is false, but may be true within the bounds
  CHECK(bounded::none(Bounded(3.0f) < a));
}

TEST_CASE("light with a bound is the run's light, and within its bound of the exact one") {
  Random random(20);
  double largest_ratio = 0;
  int unbounded = 0;
  for (int i = 0; i < 1500; ++i) {
    Lighting lighting;
    lighting.perspective = random.unit() < 0.7;
    for (int k = 0; k < 2; ++k) {
      EyeLight light;
      light.kind = LightKind(random.integer(0, 2));
      light.radiance = {float(random.unit()), float(random.unit()), 2.0f};
      light.towards = {0.6f, 0.0f, 0.8f};
      light.position = {float(random.between(-3, 3)), float(random.between(-3, 3)), 1.0f};
      light.inverse_range = random.unit() < 0.5 ? 0.2f : 0.0f;
      light.cone_scale = 4;
      light.cone_offset = -2;
      lighting.lights.push_back(light);
    }
    const double offs[] = {0, 1e-7, 1e-4, 0.05};
    const double off = offs[random.integer(0, 3)];
    std::array<float, 3> position{float(random.between(-2, 2)), float(random.between(-2, 2)), -3};
    std::array<float, 3> normal{float(random.between(-1, 1)), float(random.between(-1, 1)), 0.5f};
    if (random.unit() < 0.02) normal = {0, 0, 0};
    std::array<Bounded, 3> at, across, base;
    std::array<Big, 3> exact_at, exact_across, exact_base;
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = {position[k], off};
      exact_at[k] = Big(position[k]) + Big(off * random.between(-1, 1));
      const double turned = normal[k] == 0 ? 0 : off;
      across[k] = {normal[k], turned};
      exact_across[k] = Big(normal[k]) + Big(turned * random.between(-1, 1));
      base[k] = {0.5f, off};
      exact_base[k] = Big(0.5) + Big(off * random.between(-1, 1));
    }
    const int shininess = int(random.integer(1, 64));
    const auto reflection = bounded::reflected_light(lighting, at, across, shininess, true);
    const Reflection run = illuminate(lighting, position, normal, shininess);
    const auto exact = in_full::reflected_light(lighting, exact_at, exact_across, shininess, true);
    const std::array<float, 3> specular{0.2f, 0.3f, 0.0f};
    const auto color = bounded::reflected_color(base, across, reflection, specular, true);
    const auto exact_color =
        in_full::reflected_color(exact_base, exact_across, exact, specular, true);
    for (std::size_t k = 0; k < 3; ++k) {
      CAPTURE(i, k, off);
      REQUIRE(reflection.diffuse[k].value == run.diffuse[k]);
      REQUIRE(reflection.specular[k].value == run.specular[k]);
      REQUIRE(excess(reflection.diffuse[k], exact.diffuse[k]) <= 0);
      REQUIRE(excess(reflection.specular[k], exact.specular[k]) <= 0);
      REQUIRE(excess(color[k], exact_color[k]) <= 0);
      if (!color[k].is_bounded()) {
        ++unbounded;
      } else if (color[k].bound > 0) {
        const double error = double(abs(Big(color[k].value) - exact_color[k]));
        largest_ratio = std::max(largest_ratio, error / color[k].bound);
      }
    }
  }
  CAPTURE(largest_ratio, unbounded);
  CHECK(largest_ratio > 0.1);  // the bounds are not far too large
  CHECK(unbounded < 4500 / 50);
}

}  // namespace glassbox
