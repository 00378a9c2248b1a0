// The expected answers of lab 7, computed by the program's projections and depth codes, and in
// decimal arithmetic with 50 digits.
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/raster/depth.h>

#include "exact/number.h"
#include "labs/07-depth/cases.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_07;
using exact::Decimal;

std::string text_of(const Planes& p) {
  return fmt::format("near {}, far {}, {} range", p.near, p.far,
                     p.range == Range::kStandard ? "standard" : "reversed");
}

// One expected number with a relative bound; infinity must be exact.
Expected number(const std::string& field, double value, double relative, const std::string& unit) {
  const double bound = std::isfinite(value) ? relative * std::abs(value) : 0;
  return numbers(field, {value}, bound, unit);
}

// ---- 7.1 ----

Case expect_row(const Planes& input) {
  const DepthRange range =
      input.range == Range::kReversed ? DepthRange::kReversed : DepthRange::kStandard;
  const auto clip_from_eye = perspective_degrees(90, 1, {input.near, input.far, range});
  if (!clip_from_eye) return {};  // every pair of planes is valid
  const double a = clip_from_eye->at(2, 2), b = clip_from_eye->at(2, 3);
  const auto expect = [](double a_, double b_, double ulps = 8) {
    // The student's entries and ours are each within 4 ulps of the exact value, so they differ by
    // at most 8 ulps.
    return std::vector<Expected>{numbers("a", {a_}, ulps * ulp(a_)),
                                 numbers("b", {b_}, ulps * ulp(b_), "world units")};
  };
  // The typical mistakes. For an eye that looks along +z, z_clip = -a z + b. OpenGL's z_clip is
  // 2 z - w with w = -z_eye, which gives 2 a + 1 and 2 b; where |a| is near 1, 2 a + 1 is off by up
  // to 16 ulps more.
  return {.where = text_of(input),
          .restated = text_of(input) + "; z_clip = a z_eye + b, w_clip = -z_eye",
          .expected = expect(a, b),
          .slipped = {{"z-sign", expect(-a, b)}, {"opengl-depth", expect(2 * a + 1, 2 * b, 24)}}};
}

// ---- 7.2 ----

Case expect_distance(const DistanceCase& input) {
  Case c{input.what, text_of(input.planes) + "; depths", {}};
  for (const double depth : input.depths) {
    c.restated += fmt::format(" {}", depth);
    const bool reversed = input.planes.range == Range::kReversed;
    const Decimal d(depth), from_near = reversed ? Decimal(1) - d : d,
                            from_far = reversed ? d : Decimal(1) - d;
    Decimal inverse = from_far / Decimal(input.planes.near);
    if (std::isfinite(input.planes.far)) inverse += from_near / Decimal(input.planes.far);
    const double z = inverse.sign() == 0 ? kInfinity : double(Decimal(1) / inverse);
    // The student's rounding errors are at most 4 u (u: the unit roundoff), from 1 - depth, a
    // quotient, the sum of two numbers >= 0, and the last quotient. The rounding of the expected
    // number comes on top; student.h allows 16 u.
    c.expected.push_back(number(fmt::format("distance {}", c.expected.size()), z,
                                16 * unit_roundoff<double>, "world units"));
  }
  c.restated += extreme_case_command(input.what);
  return c;
}

// ---- 7.3 ----

DepthFormat glassbox_format(Format format) {
  switch (format) {
    case Format::kUnorm16:
      return DepthFormat::kUnorm16;
    case Format::kUnorm24:
      return DepthFormat::kUnorm24;
    case Format::kFloat32:
      return DepthFormat::kFloat32;
    case Format::kFloat32Reversed:
      break;
  }
  return DepthFormat::kFloat32Reversed;
}

Case expect_code(const CodeCase& input) {
  std::vector<double> codes;
  std::string text = fmt::format("{}; depths", name_of(input.format));
  for (const float depth : input.depths) {
    codes.push_back(glassbox::depth_code(glassbox_format(input.format), depth));
    if (codes.size() <= 8) text += fmt::format(" {}", depth);
  }
  if (codes.size() > 8) text += " ...";
  return {input.what, text + extreme_case_command(input.what), {numbers("codes", codes)}};
}

// ---- 7.4 ----

// Finds the visible fragment of each pixel by testing all fragments; and the last of several
// equally near ones, for the mistake <= in place of <.
Case expect_visible(const BufferCase& input) {
  std::vector<double> seen, seen_last;
  for (int pixel = 0; pixel < input.pixels; ++pixel) {
    double first = -1, last = -1;
    std::uint32_t nearest = kEmptyDepth;
    for (std::size_t i = 0; i < input.fragments.size(); ++i) {
      const std::uint32_t code =
          glassbox::depth_code(glassbox_format(input.format), input.fragments[i].depth);
      if (input.fragments[i].pixel != pixel) continue;
      if (!in_front(nearest, code)) last = double(i);
      if (!in_front(code, nearest)) continue;
      nearest = code;
      first = double(i);
    }
    seen.push_back(first);
    seen_last.push_back(last);
  }
  std::string text =
      fmt::format("{}, {} pixels; fragments (pixel, depth):", name_of(input.format), input.pixels);
  for (std::size_t i = 0; i < input.fragments.size() && i < 8; ++i)
    text += fmt::format(" {}: ({}, {})", i, input.fragments[i].pixel, input.fragments[i].depth);
  if (input.fragments.size() > 8) text += " ...";
  return {.where = input.what,
          .restated = text + extreme_case_command(input.what),
          .expected = {numbers("seen", seen)},
          .slipped = {{"depth-or-equal", {numbers("seen", seen_last)}}}};
}

// ---- 7.5 ----

// 1/x, and 0 for infinity.
Decimal inverse_of(double x) {
  return std::isinf(x) ? Decimal(0) : Decimal(1) / Decimal(x);
}

double ladder_rung_size(const LadderCase& input, double d) {
  const Decimal at_near = inverse_of(input.near), at_far = inverse_of(input.far),
                here = inverse_of(d);
  const Decimal whole = at_near - at_far;
  const bool reversed = input.format == Format::kFloat32Reversed;
  const double depth = double((reversed ? here - at_far : at_near - here) / whole);
  // The step of a float depends on the exponent of the depth. No depth of the cases is within 1e-10
  // of a power of two, so the student's double and ours have the same exponent.
  Decimal step = Decimal(std::ldexp(1.0, std::ilogb(depth) - 23));
  if (input.format == Format::kUnorm16 || input.format == Format::kUnorm24)
    step = Decimal(1) / Decimal(double(glassbox::depth_code(glassbox_format(input.format), 1.0f)));
  const Decimal beyond = here - step * whole;  // 1/d', with d' one step of depth behind d
  if (beyond.sign() <= 0 || (beyond - at_far).sign() < 0) return kInfinity;
  return double(here / beyond - Decimal(1));
}

Case expect_ladder(const LadderCase& input) {
  Case c{
      input.what,
      fmt::format("{}, near {}, far {}; distances", name_of(input.format), input.near, input.far),
      {}};
  for (const double d : input.distances) {
    c.restated += fmt::format(" {}", d);
    // The student computes q = step (1/near - 1/far) d. The subtraction magnifies the roundings of
    // its terms at most 3 times (far >= 2 near), so q has an error of 7 u (u: the unit roundoff).
    // The result q/(1 - q) has at most 4 times this error, since no q of the cases is between 3/4
    // and 1.
    c.expected.push_back(number(fmt::format("rung {}", c.expected.size()),
                                ladder_rung_size(input, d), 64 * unit_roundoff<double>, ""));
  }
  c.restated += extreme_case_command(input.what);
  return c;
}

}  // namespace

Lab lab_07() {
  return {
      7,
      "07-depth",
      "Depth: which surface is in front, and how surely",
      {{"7.1", "The depth row of a projection", 20},
       {"7.2", "From a depth back to its distance", 15},
       {"7.3", "The codes of four formats", 25},
       {"7.4", "A z-buffer", 20},
       {"7.5", "The ladder: how fine a format is", 20}},
      {check("the near and far planes have the ends of the range", "7.1", "clip", planes,
             expect_row),
       hidden_check("planes very close and very far apart", "7.1", "clip", more_planes, expect_row),
       check("a depth leads back to its distance", "7.2", "NDC", depths, expect_distance),
       hidden_check("depths next to the far plane's", "7.2", "NDC", more_depths, expect_distance),
       check("depths become codes", "7.3", "depth", codes, expect_code),
       hidden_check("random depths and halves", "7.3", "depth", more_codes, expect_code),
       check("the nearest fragment is seen, the first of equals", "7.4", "depth", buffers,
             expect_visible),
       hidden_check("many fragments", "7.4", "depth", more_buffers, expect_visible),
       check("the ladder of the formats", "7.5", "depth", ladders, expect_ladder),
       hidden_check("ladders of other views", "7.5", "depth", more_ladders, expect_ladder)}};
}

}  // namespace glassbox::labs
