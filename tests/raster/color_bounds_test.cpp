// The error bounds of texture samples and stored bytes, compared with exact weights, exact means
// and the transfer function by its definition.
#include <glassbox/raster/color_bounds.h>

#include <cmath>
#include <cstdio>

#include <glassbox/base/random.h>

#include "tests/raster/exact_formulas.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using bounded::Bounded;
using in_full::Big;

Image<Rgba8> random_image(Random& random) {
  Image<Rgba8> image{int(random.integer(1, 17)), int(random.integer(1, 17))};
  const bool harsh = random.unit() < 0.3;  // harsh: black texels beside white ones
  for (Rgba8& c : image.pixels) {
    const auto byte = [&] {
      return harsh ? std::uint8_t(255 * random.integer(0, 1))
                   : std::uint8_t(random.integer(0, 255));
    };
    c = {byte(), byte(), byte(), byte()};
  }
  return image;
}

Sampler random_sampler(Random& random) {
  return {Wrap(random.integer(0, 2)), Wrap(random.integer(0, 2)), Filter(random.integer(0, 1)),
          Filter(random.integer(0, 1)), MipFilter(random.integer(0, 2))};
}

// A coordinate in or near the picture, on a border or centre of a texel, or far away.
double random_coordinate(Random& random, int size) {
  switch (random.integer(0, 4)) {
    case 0:
      return double(random.integer(-2 * size, 3 * size)) / size;
    case 1:
      return (double(random.integer(-size, 2 * size)) + 0.5) / size;
    case 2:
      return random.between(-1e4, 1e4);
    case 3:
      return -random.scaled(0, 1, -60, -20);
    default:
      return random.between(-1, 2);
  }
}

}  // namespace

TEST_CASE("a texture sample is within its bound of real weights on real means") {
  Random random(68);
  double largest_ratio = 0;
  int sharp = 0, count = 0;
  for (int i = 0; i < 100; ++i) {
    const Image<Rgba8> image = random_image(random);
    const Transfer transfer = random.unit() < 0.5 ? Transfer::kSrgb : Transfer::kNone;
    const MipChain chain = make_mip_chain(image, transfer, false);
    const auto levels = in_full::levels_of(image, transfer);
    for (int k = 0; k < 300; ++k, ++count) {
      const Sampler sampler = random_sampler(random);
      const double u = random_coordinate(random, image.width);
      const double v = random_coordinate(random, image.height);
      const double offs[] = {0, 1e-7, 1e-3, 0.2, 40};
      const auto near = [&](double x) {
        const double off = offs[random.integer(0, 4)];
        const float given = float(x + off * random.between(-1, 1));
        return Bounded(given, std::abs(double(given) - x));
      };
      const std::array<Bounded, 2> at{near(u), near(v)};
      const double level =
          random.unit() < 0.2 ? double(random.integer(-2, 9)) / 2 : random.between(-1, 5);
      const float given = float(level + (random.unit() < 0.5 ? 0 : random.between(-1e-3, 1e-3)));
      const LevelBounds where{std::min(level, double(given)), std::max(level, double(given))};
      const double bound = sample_bound(chain, sampler, transfer, at, where);
      const Rgba run = sample_mip_chain(chain, sampler, {at[0].value, at[1].value}, given);
      const in_full::Light exact = in_full::sample(levels, sampler, u, v, level);
      const std::array<float, 4> values{run.r, run.g, run.b, run.a};
      CAPTURE(i, k, image.width, image.height, u, v, level, at[0].bound, at[1].bound,
              int(sampler.mip), int(sampler.magnify), int(sampler.minify), int(sampler.wrap_u),
              int(sampler.wrap_v));
      for (std::size_t c = 0; c < 4; ++c) {
        const double error = std::abs(double(values[c]) - exact[c]);
        // 1e-9 for the oracle's own rounding: doubles at coordinates of 10^4.
        REQUIRE(error <= bound + 1e-9);
        largest_ratio = std::max(largest_ratio, error / bound);
      }
      sharp += bound < 0.001;
    }
  }
  std::printf("  texture samples: largest error / bound = %.3f; below 1/1000: %d of %d\n",
              largest_ratio, sharp, count);
  CHECK(largest_ratio > 0.5);
  CHECK(sharp > count / 10);
}

TEST_CASE("the level of detail lies within its bounds") {
  Random random(69);
  int sharp = 0;
  for (int i = 0; i < 100'000; ++i) {
    const float side = float(random.scaled(0.5, 2, -60, 60));
    const float squared = side * side;
    const double shares[] = {0, 1e-7, 0.5, 1, 3};
    const double bound = double(squared) * shares[random.integer(0, 4)];
    const double exact = std::max(0.0, double(squared) + bound * random.between(-1, 1));
    const float level = level_of_detail(TextureGradient{{side, 0}, {0, 0}}, 1, 1);
    const LevelBounds bounds = level_bounds(level, {squared, bound});
    CAPTURE(squared, bound, exact, level);
    if (exact > 0) {
      const long double log = 0.5L * std::log2((long double)(exact));
      REQUIRE((long double)(bounds.low) <= log);
      REQUIRE(log <= (long double)(bounds.high));
    }
    REQUIRE(bounds.low <= double(level));
    REQUIRE(double(level) <= bounds.high);
    sharp += bounds.high - bounds.low < 1e-5;
  }
  CHECK(sharp > 10'000);
  const float nothing = -std::numeric_limits<float>::infinity();
  CHECK(level_bounds(nothing, Bounded(0.0f)).high == -std::numeric_limits<double>::infinity());
}

TEST_CASE("a stored byte is within its bound of the transfer function") {
  Random random(70);
  double largest_ratio = 0;
  for (int i = 0; i < 300'000; ++i) {
    const Transfer transfer = random.unit() < 0.5 ? Transfer::kSrgb : Transfer::kNone;
    const float light =
        random.unit() < 0.2 ? float(random.between(-0.5, 2)) : float(std::pow(random.unit(), 3));
    const double offs[] = {0, 1e-7, 1e-3, 0.5};
    const double off = offs[random.integer(0, 3)];
    const double exact = double(light) + off * random.between(-1, 1);
    const std::uint8_t stored = encode(transfer, light);
    const double bound = stored_bound(transfer, stored, {light, off});
    const double error = std::abs(double(stored) - 255 * in_full::encoded(transfer, exact));
    CAPTURE(light, off, exact, int(stored), bound);
    REQUIRE(error <= bound + 1e-9);
    if (off == 0) REQUIRE(bound <= 0.5 + 1e-9);
    largest_ratio = std::max(largest_ratio, error / bound);
    const Bounded back = light_of_stored(transfer, stored, bound);
    REQUIRE(std::abs(double(back.value) - std::clamp(exact, 0.0, 1.0)) <= back.bound + 1e-12);
  }
  CHECK(largest_ratio > 0.99);
  const double unknown = std::numeric_limits<double>::infinity();
  CHECK(stored_bound(Transfer::kSrgb, 200, {0.5f, unknown}) == 200);
}

}  // namespace glassbox
