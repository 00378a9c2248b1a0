#include "tests/support/catch.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include <glassbox/images/srgb.h>

#include <glassbox/base/random.h>

namespace {

using namespace glassbox;
using Real = boost::multiprecision::cpp_bin_float_50;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// The encoding direction of IEC 61966-2-1 (the table was made from the decoding direction). The two
// agree, because the linear and the power part meet between the bytes 10 and 11.
Real encoded(const Real& linear) {
  if (linear <= Real("0.0031308")) return linear * Real("12.92");
  return Real("1.055") * pow(linear, 1 / Real("2.4")) - Real("0.055");
}

// Returns 255 times the encoded value, rounded to the nearest integer, halves upwards.
int nearest_byte(float linear) {
  return int(floor(255 * encoded(Real(linear)) + Real("0.5")));
}

}  // namespace

TEST_CASE("every sRGB threshold is the first float of its byte") {
  for (int k = 1; k < 256; ++k) {
    CAPTURE(k);
    const float at = kSrgbThreshold[std::size_t(k)];
    const float below = std::nextafter(at, 0.0f);
    CHECK(nearest_byte(at) == k);
    CHECK(nearest_byte(below) == k - 1);
    CHECK(int(encode_srgb(at)) == k);
    CHECK(int(encode_srgb(below)) == k - 1);
  }
}

TEST_CASE("every sRGB byte decodes to the nearest float and encodes back to itself") {
  for (int k = 0; k < 256; ++k) {
    CAPTURE(k);
    const float linear = decode_srgb(std::uint8_t(k));
    CHECK(int(encode_srgb(linear)) == k);
    // Decoding, computed here independently: the table's float must be at least as close to the
    // true value as its two neighbours.
    const Real v = Real(k) / 255;
    const Real light = v <= Real("0.04045")
                           ? Real(v / Real("12.92"))
                           : Real(pow((v + Real("0.055")) / Real("1.055"), Real("2.4")));
    const Real distance = abs(Real(linear) - light);
    CHECK(distance <= abs(Real(std::nextafter(linear, -1.0f)) - light));
    CHECK(distance <= abs(Real(std::nextafter(linear, 2.0f)) - light));
  }
}

TEST_CASE("the sRGB encoder agrees with 50-digit arithmetic on random floats") {
  const std::uint64_t seed = 41;
  CAPTURE(seed);
  Random random(seed);
  for (int i = 0; i < 20000; ++i) {
    // Every other number is small, where the floats are dense.
    const float linear = float(i % 2 ? random.unit() : random.scaled(0, 1, -14, 0));
    CAPTURE(linear);
    REQUIRE(int(encode_srgb(linear)) == nearest_byte(linear));
  }
}

TEST_CASE("the sRGB encoder never decreases, bucket by bucket") {
  // Tests both sides of every bucket of the encoder's first guess, and of every half bucket.
  int before = 0;
  for (std::uint32_t bits = 0; bits <= std::bit_cast<std::uint32_t>(2.0f); bits += 1u << 15) {
    for (const std::uint32_t neighbour : {bits, bits + 1, bits + (1u << 15) - 1}) {
      const int byte = encode_srgb(std::bit_cast<float>(neighbour));
      CAPTURE(neighbour, before);
      REQUIRE(byte >= before);
      before = byte;
    }
  }
  CHECK(before == 255);
}

TEST_CASE("both encoders clamp, and NaN becomes 0") {
  for (const float low :
       {-kInfinity, -1.0f, -0.0f, 0.0f, 1e-45f, std::numeric_limits<float>::quiet_NaN()}) {
    CAPTURE(low);
    CHECK(int(encode_srgb(low)) == 0);
    CHECK(int(encode_unorm8(low)) == 0);
  }
  for (const float high : {1.0f, std::nextafter(1.0f, 0.0f), 1.5f, 1e30f, kInfinity}) {
    CAPTURE(high);
    CHECK(int(encode_srgb(high)) == 255);
    CHECK(int(encode_unorm8(high)) == 255);
  }
}

TEST_CASE("plain bytes round to the nearest, exactly at every half") {
  for (int k = 0; k < 256; ++k) {
    CAPTURE(k);
    CHECK(int(encode_unorm8(decode_unorm8(std::uint8_t(k)))) == k);
  }
  for (int k = 1; k < 256; ++k) {
    CAPTURE(k);
    // (k - 1/2) / 255 is not a float (255 is odd), so it is between two neighbouring floats; 50
    // digits tell which of them is above.
    const Real half = (Real(k) - Real("0.5")) / 255;
    float above = float(half);
    while (Real(above) < half) above = std::nextafter(above, 2.0f);
    while (Real(std::nextafter(above, 0.0f)) >= half) above = std::nextafter(above, 0.0f);
    CHECK(int(encode_unorm8(above)) == k);
    CHECK(int(encode_unorm8(std::nextafter(above, 0.0f))) == k - 1);
  }
}
