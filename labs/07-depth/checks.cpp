// The expected answers of lab 7, computed by the program's projections and depth codes, and in
// decimal arithmetic with 50 digits.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>
#include <glassbox/raster/depth.h>

#include "exact/number.h"
#include "labs/07-depth/generators.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_07;
using exact::Decimal;
using exact::inverse_of;

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

struct ExactRow {
  double a = 0, b = 0;  // the nearest doubles
};

ExactRow exact_row(const Planes& input) {
  const bool reversed = input.range == Range::kReversed;
  if (std::isinf(input.far)) return reversed ? ExactRow{0, input.near} : ExactRow{-1, -input.near};
  const Decimal near(input.near), far(input.far), length = far - near;
  const Decimal b = near * far / length;
  return reversed ? ExactRow{double(near / length), double(b)}
                  : ExactRow{double(-far / length), double(-b)};
}

// The student's entry is within 4 ulps of the exact value, and the expected one within 1/2 ulp.
std::vector<Expected> row_fields(double a, double b, double ulps = 4.5) {
  return {numbers("a", {a}, ulps * ulp(a)), numbers("b", {b}, ulps * ulp(b), "world units")};
}

Case expect_row(const Planes& input) {
  const auto [a, b] = exact_row(input);
  // The typical mistakes. For an eye that looks along +z, z_clip = -a z + b. OpenGL's z_clip is
  // 2 z - w with w = -z_eye, which gives 2 a + 1 and 2 b; where |a| is near 1, 2 a + 1 is off by up
  // to 16 ulps more.
  return {.where = text_of(input),
          .restated = text_of(input) + "; z_clip = a z_eye + b, w_clip = -z_eye",
          .expected = row_fields(a, b),
          .slipped = {{"z-sign", row_fields(-a, b)},
                      {"opengl-depth", row_fields(2 * a + 1, 2 * b, 24)}}};
}

bool right_row(const Planes& input, const Answer& answer) {
  const auto [a, b] = exact_row(input);
  return has_fields(answer, row_fields(a, b));
}

// ---- 7.2 ----

double exact_distance(const Planes& planes, double depth) {
  const bool reversed = planes.range == Range::kReversed;
  const Decimal d(depth), from_near = reversed ? Decimal(1) - d : d,
                          from_far = reversed ? d : Decimal(1) - d;
  Decimal inverse = from_far / Decimal(planes.near);
  if (std::isfinite(planes.far)) inverse += from_near / Decimal(planes.far);
  return inverse.sign() == 0 ? kInfinity : double(Decimal(1) / inverse);
}

// The student's rounding errors are at most 4 u (u: the unit roundoff), from 1 - depth, a quotient,
// the sum of two numbers >= 0, and the last quotient. The rounding of the expected number comes on
// top; student.h allows 16 u.
std::vector<Expected> distance_fields(const DistanceCase& input) {
  std::vector<Expected> fields;
  for (const double depth : input.depths)
    fields.push_back(number(fmt::format("distance {}", fields.size()),
                            exact_distance(input.planes, depth), 16 * unit_roundoff<double>,
                            "world units"));
  return fields;
}

Case expect_distance(const DistanceCase& input) {
  Case c{input.what, text_of(input.planes) + "; depths", distance_fields(input)};
  for (const double depth : input.depths) c.restated += fmt::format(" {}", depth);
  c.restated += extreme_case_command(input.what);
  return c;
}

bool right_distance(const DistanceCase& input, const Answer& answer) {
  return has_fields(answer, distance_fields(input));
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

bool right_code(const CodeCase& input, const Answer& answer) {
  const auto* codes = find_field(answer, "codes");
  return codes != nullptr && codes->size() == 1 &&
         (*codes)[0] == glassbox::depth_code(glassbox_format(input.format), input.depths[0]);
}

// ---- 7.4 ----

// The visible fragment of each pixel, found by testing all fragments; and the last of several
// equally near ones, for the mistake <= in place of <.
struct Seen {
  std::vector<double> first, last;
};

Seen seen_in(const BufferCase& input) {
  Seen seen;
  std::vector<std::uint32_t> codes;
  for (const lab_07::Fragment& each : input.fragments)
    codes.push_back(glassbox::depth_code(glassbox_format(input.format), each.depth));
  for (int pixel = 0; pixel < input.pixels; ++pixel) {
    double first = -1, last = -1;
    std::uint32_t nearest = kEmptyDepth;
    for (std::size_t i = 0; i < input.fragments.size(); ++i) {
      if (input.fragments[i].pixel != pixel) continue;
      if (!in_front(nearest, codes[i])) last = double(i);
      if (!in_front(codes[i], nearest)) continue;
      nearest = codes[i];
      first = double(i);
    }
    seen.first.push_back(first);
    seen.last.push_back(last);
  }
  return seen;
}

Case expect_visible(const BufferCase& input) {
  const auto [seen, seen_last] = seen_in(input);
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

bool right_visible(const BufferCase& input, const Answer& answer) {
  const auto* seen = find_field(answer, "seen");
  return seen != nullptr && *seen == seen_in(input).first;
}

// ---- 7.5 ----

// Depth is linear in 1/d.
struct Inverses {
  Decimal at_far, here, whole;  // 1/far, 1/d, 1/near - 1/far
  double depth = 0;             // at d, in the format's range
};

Inverses inverses_of(const LadderCase& input, double d) {
  const Decimal at_near = inverse_of<Decimal>(input.near);
  Inverses made{inverse_of<Decimal>(input.far), inverse_of<Decimal>(d), {}};
  made.whole = at_near - made.at_far;
  const bool reversed = input.format == Format::kFloat32Reversed;
  made.depth = double((reversed ? made.here - made.at_far : at_near - made.here) / made.whole);
  return made;
}

// One step of a format at this depth. The step of a float depends on the exponent of the depth.
Decimal step_of(Format format, double depth) {
  if (format == Format::kUnorm16 || format == Format::kUnorm24)
    return Decimal(1) / Decimal(format == Format::kUnorm16 ? 65535 : 16777215);
  return Decimal(std::ldexp(1.0, std::ilogb(depth) - 23));
}

struct Rung {
  // As if there were no far plane: d/d' = 1/(1 + r), which may be 0 or less; and r = (d' - d)/d,
  // infinite if there is no d'.
  double ratio = 0, size = 0;
  bool beyond_far = false;  // d' is beyond the far plane, or there is none
  bool near_far = false;    // d' is so near to the far plane that rounding may decide
};

// How near that is, relative to 1/d. A student's d/d' = 1 - q has an error of 8 u: q = step (1/near
// - 1/far) d has one of 7 u, because the subtraction magnifies the roundings of its terms at most 3
// times (far >= 2 near). Two quotients make it 1/d' and 1/far: 10 u, which is 1.1e-15.
constexpr double kNearFar = 1e-14;

Rung rung_with_step(const Inverses& at, const Decimal& step) {
  const Decimal beyond = at.here - step * at.whole;  // 1/d', with d' one step of depth behind d
  const Decimal left = beyond - at.at_far;
  const bool none = beyond.sign() <= 0;
  return {double(beyond / at.here), none ? kInfinity : double(at.here / beyond - Decimal(1)),
          none || left.sign() < 0, abs(left) < at.here * Decimal(kNearFar)};
}

// No depth of the listed and hidden cases is within 10^-11 of a power of two (see right_rung), so
// the student's double and ours have the same exponent.
double ladder_rung_size(const LadderCase& input, double d) {
  const Inverses at = inverses_of(input, d);
  const Rung rung = rung_with_step(at, step_of(input.format, at.depth));
  return rung.beyond_far ? kInfinity : rung.size;
}

Case expect_ladder(const LadderCase& input) {
  Case c{
      input.what,
      fmt::format("{}, near {}, far {}; distances", name_of(input.format), input.near, input.far),
      {}};
  for (const double d : input.distances) {
    c.restated += fmt::format(" {}", d);
    // q has an error of 7 u (see kNearFar). The result q/(1 - q) has at most 4 times this error,
    // since no q of the listed and hidden cases is between 3/4 and 1.
    c.expected.push_back(number(fmt::format("rung {}", c.expected.size()),
                                ladder_rung_size(input, d), 64 * unit_roundoff<double>, ""));
  }
  c.restated += extreme_case_command(input.what);
  return c;
}

// A relative error of at most 64 u; for a result r above 3, an error of 1/(1 + r) of at most 12 u.
// q has an error of 7 u (see kNearFar), which q/(1 - q) magnifies 1/(1 - q) = 1 + r times; so up to
// r = 3 it is 28 u, and two more roundings follow. 1/(1 + r) is 1 - q again, with the 7 u of q; the
// subtraction, the quotient q/(1 - q) and the comparison here add u/4 to u each.
bool is_rung(double given, const Rung& rung) {
  if (given == kInfinity) return rung.beyond_far || rung.near_far;
  if (rung.beyond_far && !rung.near_far) return false;
  constexpr double u = unit_roundoff<double>;
  if (std::isfinite(rung.size) && std::abs(given - rung.size) <= 64 * u * rung.size) return true;
  return rung.size > 3 && std::abs(1 / (1 + given) - rung.ratio) <= 12 * u;
}

bool right_rung(const LadderCase& input, const Answer& answer) {
  const auto* values = find_field(answer, "rung 0");
  if (values == nullptr || values->size() != 1 || !((*values)[0] > 0)) return false;
  const Inverses at = inverses_of(input, input.distances[0]);
  // A power of two as near to the depth as this may be taken for its other side. d is 10^-4 of
  // itself away from the plane whose depth is 0. So 1/near - 1/d (or 1/d - 1/far) magnifies the
  // roundings of its two terms 10^4 times, to 2 u 10^4 = 2.22e-12; the divisor and two more
  // roundings add 6 u.
  constexpr double kNearPower = 1e-11;
  return std::ranges::any_of(std::array{1 - kNearPower, 1 + kNearPower}, [&](double beside) {
    const Decimal step = step_of(input.format, at.depth * beside);
    return is_rung((*values)[0], rung_with_step(at, step));
  });
}

Case expect_rung(const LadderCase& input) {
  Case c = expect_ladder(input);
  c.judge = [input, plain = c](const Answer& answer) -> std::optional<Divergence> {
    if (right_rung(input, answer)) return std::nullopt;
    return judge_case(plain, answer);
  };
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
       generated_check("any two planes", "7.1", "clip", generated_planes, expect_row, right_row),
       hidden_check("planes very close and very far apart", "7.1", "clip", more_planes, expect_row),
       check("a depth leads back to its distance", "7.2", "NDC", depths, expect_distance),
       generated_check("any depth", "7.2", "NDC", generated_depths, expect_distance,
                       right_distance),
       hidden_check("depths next to the far plane's", "7.2", "NDC", more_depths, expect_distance),
       check("depths become codes", "7.3", "depth", codes, expect_code),
       generated_check("any depth to a code", "7.3", "depth", generated_codes, expect_code,
                       right_code),
       hidden_check("random depths and halves", "7.3", "depth", more_codes, expect_code),
       check("the nearest fragment is seen, the first of equals", "7.4", "depth", buffers,
             expect_visible),
       generated_check("any fragments", "7.4", "depth", generated_buffers, expect_visible,
                       right_visible),
       hidden_check("many fragments", "7.4", "depth", more_buffers, expect_visible),
       check("the ladder of the formats", "7.5", "depth", ladders, expect_ladder),
       generated_check("any rung", "7.5", "depth", generated_ladders, expect_rung, right_rung),
       hidden_check("ladders of other views", "7.5", "depth", more_ladders, expect_ladder)}};
}

}  // namespace glassbox::labs
