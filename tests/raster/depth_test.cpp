// Depth codes: their end points, their order, and the resolution of each depth format (B.3).
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>

#include "tests/raster/exact.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using namespace glassbox::test;

constexpr std::array<DepthFormat, 4> kFormats{DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                              DepthFormat::kUnorm24, DepthFormat::kUnorm16};

// ---- the z-fighting ladder ----

constexpr double kNear = 0.1, kFar = 1e4;

// The depth of a quad that faces the eye at distance z, after projection, divide, setup and
// interpolation.
float depth_of_quad(float z, const Transform<Clip, Eye, float>& clip_from_eye) {
  std::array<ScreenVertex, 3> t;
  const float xy[3][2] = {{-z, -z}, {z, -z}, {-z, z}};
  for (std::size_t k = 0; k < 3; ++k) {
    const NdcVertex ndc = divide(clip_from_eye * Point<Eye>{xy[k][0], xy[k][1], -z});
    t[k] = {{4 + 4 * ndc.position.x, 4 - 4 * ndc.position.y, ndc.position.z}, ndc.inverse_w};
  }
  const auto setup = setup_triangle(t);
  REQUIRE(setup);
  float depth = -1;
  for_each_covered(*setup, {2, 5, 3, 6},
                   [&](const Coverage& pixel) { depth = interpolate(*setup, pixel).depth; });
  REQUIRE(depth >= 0);
  return depth;
}

// The depth after OpenGL's default clip control: z' = 2 z - 1 on the way in, (z' + 1) / 2 on the
// way out (C-63).
float through_gl(float depth) {
  const float gl = 2.0f * depth - 1.0f;
  return (gl + 1.0f) * 0.5f;
}

// For one quad, the smallest relative distance, on a ladder of factor 1.1, from which on a second
// quad that is farther by this much is behind the first one. Infinity if not even the far plane is
// behind it.
template <class CodeOf>
double resolved_step(float near, const CodeOf& code_of) {
  double resolved = INFINITY;
  for (double step = std::min(0.25, kFar / double(near) - 1); step > 1e-9; step /= 1.1) {
    const float far = float(double(near) * (1 + step));
    if (far <= near || !in_front(code_of(near), code_of(far))) break;
    resolved = step;
  }
  return resolved;
}

// The largest resolved_step of many quads around distance z.
template <class CodeOf>
double worst_step(double z, const CodeOf& code_of) {
  Random random(56);
  double worst = 0;
  for (int i = 0; i < 101; ++i) {
    worst = std::max(worst, resolved_step(float(z * random.between(0.98, 1.02)), code_of));
  }
  return worst;
}

}  // namespace

TEST_CASE("fixed-point depth rounds half up and reaches its end points (C-61)") {
  CHECK(depth_code(DepthFormat::kUnorm24, 1.0f) == 0xffffff);
  CHECK(depth_code(DepthFormat::kUnorm24, 0.0f) == 0);
  // (1 - 2^-24)(2^24 - 1) = 2^24 - 2 + 2^-24.
  CHECK(depth_code(DepthFormat::kUnorm24, 1.0f - 0x1p-24f) == 0xfffffe);
  CHECK(depth_code(DepthFormat::kUnorm16, 1.0f) == 0xffff);
  CHECK(depth_code(DepthFormat::kUnorm16, 1.0f - 0x1p-24f) == 0xffff);
  CHECK(depth_code(DepthFormat::kUnorm16, 0.5f) == 0x8000);  // 32767.5 is rounded up
  CHECK(depth_code(DepthFormat::kUnorm24, 0.5f) == 0x800000);
  CHECK(depth_code(DepthFormat::kUnorm24, 0x1p-149f) == 0);
  // The naive code 2^24 z overflows into the next field.
  CHECK(std::uint32_t(1.0f * 0x1p24f) > 0xffffffu);
}

TEST_CASE("fixed-point depth is exactly floor(z (2^bits - 1) + 1/2)") {
  Random random(61);
  for (int i = 0; i < 20000; ++i) {
    const float z = float(random.scaled(0, 1, -32, 0));
    for (const int bits : {16, 24}) {
      const std::int64_t code = unorm_depth_code(z, std::ldexp(1.0, bits) - 1);
      // 2 code <= 2 z (2^bits - 1) + 1 < 2 code + 2, where z = mantissa 2^-shift exactly.
      int exponent = 0;
      const auto mantissa = std::int64_t(std::ldexp(std::frexp(z, &exponent), 24));
      const int shift = 24 - exponent;  // at most 24 + 32 + 53: z is 0 or at least 2^-85
      if (mantissa == 0) {
        REQUIRE(code == 0);
        continue;
      }
      const Int128 one = Int128(1) << shift;
      const Int128 doubled = Int128(mantissa) * (2 * ((std::int64_t(1) << bits) - 1)) + one;
      CAPTURE(z, bits);
      REQUIRE(2 * code * one <= doubled);
      REQUIRE(doubled < (2 * code + 2) * one);
    }
  }
}

TEST_CASE("a nearer fragment never has a larger code, in any format") {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const float a = float(random.scaled(0, 1, -40, 0));
    const float b = random.integer(0, 1) == 0 ? std::nextafter(a, 2.0f) : float(random.unit());
    const float near = std::min(a, b), far = std::max(a, b);
    CAPTURE(near, far);
    for (const DepthFormat format : kFormats) {
      const bool reversed = format == DepthFormat::kFloat32Reversed;
      const std::uint32_t front = depth_code(format, reversed ? far : near);
      const std::uint32_t back = depth_code(format, reversed ? near : far);
      REQUIRE(front <= back);
      if (near == far) REQUIRE(!in_front(front, back));
      const bool is_float = reversed || format == DepthFormat::kFloat32;
      if (is_float && near < far) REQUIRE(in_front(front, back));
    }
  }
}

TEST_CASE("an empty buffer is behind everything, also what lies exactly on the far plane (C-62)") {
  for (const DepthFormat format : kFormats) {
    for (const float depth : {0.0f, -0.0f, 0x1p-149f, 0.5f, 1.0f}) {
      CAPTURE(int(format), depth);
      CHECK(in_front(depth_code(format, depth), kEmptyDepth));
    }
  }
}

TEST_CASE("depth outside [0, 1] is clamped, and not a number counts as 0") {
  for (const DepthFormat format : kFormats) {
    CAPTURE(int(format));
    CHECK(depth_code(format, -0.1f) == depth_code(format, 0.0f));
    CHECK(depth_code(format, -0.0f) == depth_code(format, 0.0f));
    CHECK(depth_code(format, 1.0000001f) == depth_code(format, 1.0f));
    CHECK(depth_code(format, INFINITY) == depth_code(format, 1.0f));
    CHECK(depth_code(format, NAN) == depth_code(format, 0.0f));
  }
}

TEST_CASE(
    "the z-fighting ladder: each format resolves what table B.3 says, within a factor of 2 (C-56, "
    "C-63)") {
  const auto standard =
      round_to_float(*perspective_degrees(90, 1, {kNear, kFar, DepthRange::kStandard}));
  const auto reversed =
      round_to_float(*perspective_degrees(90, 1, {kNear, kFar, DepthRange::kReversed}));
  const auto infinite = round_to_float(*perspective_degrees(
      90, 1, {kNear, std::numeric_limits<double>::infinity(), DepthRange::kReversed}));
  const std::array<double, 6> distances{0.2, 1, 10, 100, 1000, 9000};
  struct Row {
    const char* name;
    DepthFormat format;
    const Transform<Clip, Eye, float>& projection;
    bool gl;
    std::array<double, 6> table;
  };
  constexpr double kNone = INFINITY;
  // The smallest relative distance that each format resolves, at each distance. The values are
  // those of a table (B.3), except two that are less than half of the table's own law z 2^-bits/n,
  // which holds for every quad and not only for a lucky one: unorm16 at 100 (5.8e-3 in the table)
  // and float32 at 9000 (2.3e-3). There the law's value is used.
  const std::array<Row, 6> rows{Row{"unorm16",
                                    DepthFormat::kUnorm16,
                                    standard,
                                    false,
                                    {3.0e-5, 1.5e-4, 1.5e-3, 1.5e-2, 6.5e-2, kNone}},
                                Row{"unorm24",
                                    DepthFormat::kUnorm24,
                                    standard,
                                    false,
                                    {1.2e-7, 5.8e-7, 5.9e-6, 6.0e-5, 5.8e-4, 5.4e-3}},
                                Row{"float32",
                                    DepthFormat::kFloat32,
                                    standard,
                                    false,
                                    {1.4e-7, 5.7e-7, 6.0e-6, 5.8e-5, 6.6e-4, 5.4e-3}},
                                Row{"float32 reversed",
                                    DepthFormat::kFloat32Reversed,
                                    reversed,
                                    false,
                                    {7e-8, 1.2e-7, 9.5e-8, 1.5e-7, 1.2e-7, 1.0e-7}},
                                Row{"float32 reversed, infinite far plane",
                                    DepthFormat::kFloat32Reversed,
                                    infinite,
                                    false,
                                    {7e-8, 1.2e-7, 9.5e-8, 1.5e-7, 1.2e-7, 1.0e-7}},
                                Row{"float32 reversed through OpenGL's [-1, 1]",
                                    DepthFormat::kFloat32Reversed,
                                    reversed,
                                    true,
                                    {7e-8, 3.1e-7, 3.0e-6, 3.0e-5, 3.3e-4, 5.0e-3}}};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < 6; ++i) {
      const double step = worst_step(distances[i], [&](float z) {
        const float depth = depth_of_quad(z, row.projection);
        return depth_code(row.format, row.gl ? through_gl(depth) : depth);
      });
      CAPTURE(row.name, distances[i], row.table[i], step);
      // A factor of 2, and one step of the ladder.
      CHECK(step <= 2.2 * row.table[i]);
      CHECK(step >= row.table[i] / 2.2);
    }
  }
}

TEST_CASE("reversed depth through OpenGL's [-1, 1] loses what reversing gained (C-63)") {
  const auto reversed =
      round_to_float(*perspective_degrees(90, 1, {kNear, kFar, DepthRange::kReversed}));
  const float near = depth_of_quad(1000.0f, reversed), far = depth_of_quad(1000.01f, reversed);
  const DepthFormat format = DepthFormat::kFloat32Reversed;
  CHECK(in_front(depth_code(format, near), depth_code(format, far)));
  CHECK(!in_front(depth_code(format, through_gl(near)), depth_code(format, through_gl(far))));
}
