// Colour encoding, write masks and blending.
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/raster/blend.h>

#include "tests/support/catch.h"

namespace {

using namespace glassbox;

constexpr Transfer kTransfers[] = {Transfer::kSrgb, Transfer::kNone};

Rgba8 random_texel(Random& random) {
  const std::uint64_t bits = random.bits();
  return {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16),
          std::uint8_t(bits >> 24)};
}

Rgba decoded(Transfer transfer, const Rgba8& c) {
  return {decode(transfer, c.r), decode(transfer, c.g), decode(transfer, c.b), decode_unorm8(c.a)};
}

}  // namespace

TEST_CASE("every byte survives decoding and encoding") {
  for (const Transfer transfer : kTransfers) {
    for (int byte = 0; byte < 256; ++byte) {
      const auto b = std::uint8_t(byte);
      CAPTURE(byte);
      REQUIRE(encode(transfer, decode(transfer, b)) == b);
      REQUIRE(encode(transfer, decoded(transfer, {b, b, b, b})) == Rgba8{b, b, b, b});
    }
  }
}

TEST_CASE("colours outside [0, 1] are clamped, and not a number is black") {
  for (const Transfer transfer : kTransfers) {
    CHECK(encode(transfer, Rgba{-1.0f, 2.0f, NAN, INFINITY}) == Rgba8{0, 255, 0, 255});
    CHECK(encode(transfer, Rgba{-INFINITY, 0.0f, 1.0f, NAN}) == Rgba8{0, 0, 255, 0});
  }
}

TEST_CASE("blending with alpha 0 keeps every byte, and with alpha 1 replaces it") {
  Random random(1);
  for (const Transfer transfer : kTransfers) {
    for (int i = 0; i < 5000; ++i) {
      const Rgba8 stored = random_texel(random), drawn = random_texel(random);
      Rgba source = decoded(transfer, drawn);
      source.a = 0.0f;
      REQUIRE(blend_over(transfer, source, stored) == stored);
      source.a = 1.0f;
      REQUIRE(blend_over(transfer, source, stored) == Rgba8{drawn.r, drawn.g, drawn.b, 255});
    }
  }
}

TEST_CASE("blending is the weighted mean in linear light") {
  // The products of c and of keep and their sum are rounded: 4 roundings of numbers up to 1, so at
  // most 4 u = 2.4e-7 from the exact value, which is 6.1e-5 of a byte; then the byte is the nearest
  // one.
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const Rgba8 stored = random_texel(random), drawn = random_texel(random);
    const Rgba source = decoded(Transfer::kNone, drawn);
    const Rgba8 found = blend_over(Transfer::kNone, source, stored);
    const double a = drawn.a / 255.0;
    const auto near = [](int byte, double exact) { return std::abs(byte - exact) <= 0.5 + 1e-4; };
    CHECK(near(found.r, drawn.r * a + stored.r * (1 - a)));
    CHECK(near(found.g, drawn.g * a + stored.g * (1 - a)));
    CHECK(near(found.b, drawn.b * a + stored.b * (1 - a)));
    CHECK(near(found.a, drawn.a + stored.a * (1 - a)));
  }
  // White that half covers black gives half the light, which is 188 in sRGB, not 128.
  CHECK(blend_over(Transfer::kSrgb, {1, 1, 1, 0.5f}, {0, 0, 0, 255}) == Rgba8{188, 188, 188, 255});
  CHECK(blend_over(Transfer::kNone, {1, 1, 1, 0.5f}, {0, 0, 0, 255}) == Rgba8{128, 128, 128, 255});
}

TEST_CASE("a mask writes the channels that it names and no other (S0-05)") {
  for (int bits = 0; bits < 16; ++bits) {
    const ColorMask mask{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
    Rgba8 stored{1, 2, 3, 4};
    write_masked(mask, {11, 12, 13, 14}, stored);
    CHECK(stored.r == (mask.r ? 11 : 1));
    CHECK(stored.g == (mask.g ? 12 : 2));
    CHECK(stored.b == (mask.b ? 13 : 3));
    CHECK(stored.a == (mask.a ? 14 : 4));
  }
  // An anaglyph: the left eye's red and the right eye's green and blue meet in one pixel.
  Rgba8 stored{0, 0, 0, 255};
  write_masked({true, false, false, true}, {200, 100, 50, 255}, stored);
  write_masked({false, true, true, true}, {20, 10, 5, 255}, stored);
  CHECK(stored == Rgba8{200, 10, 5, 255});
}
