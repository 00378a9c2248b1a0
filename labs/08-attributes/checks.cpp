// The expected answers of tasks 8.1 to 8.4, at pixels and in rows of pixels, computed in exact
// rational numbers.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>

#include "exact/number.h"
#include "labs/08-attributes/generators.h"
#include "labs/08-attributes/surface_checks.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_08;
using exact::Decimal;
using exact::decimal_from;
using exact::Rational;

constexpr double u24 = double(unit_roundoff<float>);
constexpr double u53 = unit_roundoff<double>;

// The number of a field that has one; NaN if there is no such field.
double number_in(const Answer& answer, const char* field) {
  const auto* values = find_field(answer, field);
  return values != nullptr && values->size() == 1 ? (*values)[0] : NAN;
}

// ---- one pixel ----

// Whether coordinate i is the same at all vertices, so that it must be exact.
bool is_same_at_vertices(const PixelOfTriangle& at, std::size_t i) {
  return at.texcoords[0][i] == at.texcoords[1][i] && at.texcoords[0][i] == at.texcoords[2][i];
}

Case expect_pixel(const PixelCase& input) {
  const PixelOfTriangle& at = input.at;
  std::array<Rational, 3> share;
  Rational q, area;
  for (std::size_t k = 0; k < 3; ++k) {
    area += Rational(at.edges[k]);
    share[k] = Rational(at.edges[k]) * Rational(double(at.inverse_w[k]));
    q += share[k];
  }
  std::vector<Expected> expected, affine;
  for (std::size_t i = 0; i < 2; ++i) {
    Rational sum, spread, even, even_spread;
    const Rational a0(double(at.texcoords[0][i]));
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational a(double(at.texcoords[k][i]));
      sum += share[k] * a;
      spread += share[k] * abs(a - a0);
      even += Rational(at.edges[k]) * a;
      even_spread += Rational(at.edges[k]) * abs(a - a0);
    }
    const double value = double(sum / q);
    // The bound, where u24 = 2^-24 is the unit roundoff of float. raster/formulas/interpolate.h
    // derives 13 u24 times the spread (the weighted mean distance of the vertices' values from
    // vertex 0's), which includes the rounding of the edge functions, plus a last rounding. Here it
    // is 16 u24, because a student may also divide by the area, which rounds 1/w and u/w once more.
    const double bound =
        is_same_at_vertices(at, i) ? 0 : 16 * u24 * double(spread / q) + u24 * std::abs(value);
    expected.push_back(numbers(i == 0 ? "u" : "v", {value}, bound));
    // The wrong answer "affine": it uses the weights on the screen, without perspective.
    const double on_screen = double(even / area);
    affine.push_back(numbers(i == 0 ? "u" : "v", {on_screen},
                             16 * u24 * double(even_spread / area) + u24 * std::abs(on_screen)));
  }
  std::string text =
      fmt::format("edge functions {}, {}, {}; 1/w {:.9g}, {:.9g}, {:.9g};", at.edges[0],
                  at.edges[1], at.edges[2], at.inverse_w[0], at.inverse_w[1], at.inverse_w[2]);
  for (const auto& [u, v] : at.texcoords) text += fmt::format(" (u, v) = ({:.9g}, {:.9g})", u, v);
  const auto part = [](const Rational& of, const Rational& sum) { return double(of / sum); };
  text += fmt::format(
      "\nweights on the screen {:.6g}, {:.6g}, {:.6g}; on the triangle {:.6g}, {:.6g}, {:.6g}",
      part(Rational(at.edges[0]), area), part(Rational(at.edges[1]), area),
      part(Rational(at.edges[2]), area), part(share[0], q), part(share[1], q), part(share[2], q));
  if (*input.command != 0) text += fmt::format("\n{}", input.command);
  return {
      .where = input.what, .restated = text, .expected = expected, .slipped = {{"affine", affine}}};
}

bool right_pixel(const PixelCase& input, const Answer& answer) {
  const PixelOfTriangle& at = input.at;
  std::array<double, 3> share;
  for (std::size_t k = 0; k < 3; ++k) share[k] = double(at.edges[k]) * double(at.inverse_w[k]);
  const double q = share[0] + share[1] + share[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const double a0 = at.texcoords[0][i];
    const double d1 = at.texcoords[1][i] - a0, d2 = at.texcoords[2][i] - a0;
    const double value = a0 + (share[1] * d1 + share[2] * d2) / q;
    const double spread = (share[1] * std::abs(d1) + share[2] * std::abs(d2)) / q;
    const double bound = is_same_at_vertices(at, i) ? 0 : 16 * u24 * spread + u24 * std::abs(value);
    // The error of the value is at most 16 u53 of the spread and u53 of the value, which is 2^-29
    // of the bound. Where that could decide, exact numbers do.
    const double distance = std::abs(number_in(answer, i == 0 ? "u" : "v") - value);
    if (!(distance <= bound * (1 + 0x1p-20))) return false;
    if (distance > bound * (1 - 0x1p-20)) return !judge_case(expect_pixel(input), answer);
  }
  return true;
}

// ---- rows of pixels ----

struct ExactSpanPoint {
  Rational q, u;
};

ExactSpanPoint exact_span_point(const Line& line, int x) {
  const Rational far = Rational(x) / Rational(line.pixels), near = Rational(1) - far;
  const Rational q0 = near * Rational(line.inverse_w0), q1 = far * Rational(line.inverse_w1);
  const Rational q = q0 + q1;
  return {q, (q0 * Rational(line.u0) + q1 * Rational(line.u1)) / q};
}

// R |u| in the error bounds of student.h: an error that is relative to the largest u/w is divided
// by the smallest 1/w. R is the largest 1/w over the smallest one, and |u| the largest coordinate.
double scale_of(const Line& line) {
  const double larger = std::max(line.inverse_w0, line.inverse_w1);
  return larger / std::min(line.inverse_w0, line.inverse_w1) *
         std::max(std::abs(line.u0), std::abs(line.u1));
}

std::string line_text(const Line& line) {
  return fmt::format("u from {} to {}, 1/w from {} to {}, over {} pixels", line.u0, line.u1,
                     line.inverse_w0, line.inverse_w1, line.pixels);
}

// The bound is for a student who adds up 1/w and u/w from pixel to pixel: each of the two sums
// rounds `pixels` times, and the values at both ends and the division round a few times more. A
// student who adds up u within each span needs 1/w and u/w only at the ends of spans, and so has no
// more roundings in total.
Case expect_span(const SpanCase& input) {
  const Line& line = input.line;
  std::vector<double> values, at_borders, even;
  for (int first = 0; first < line.pixels; first += input.every) {
    const int end = std::min(first + input.every, line.pixels);
    const Rational start = exact_span_point(line, first).u;
    const Rational step = (exact_span_point(line, end).u - start) / Rational(end - first);
    for (int x = first; x < end; ++x) {
      values.push_back(double(start + step * (Rational(2 * (x - first) + 1) / Rational(2))));
      at_borders.push_back(double(start + step * Rational(x - first)));
      even.push_back(line.u0 + (x + 0.5) / line.pixels * (line.u1 - line.u0));
    }
  }
  const double bound = 2 * (line.pixels + 8) * u53 * scale_of(line);
  const auto expected = [&](const std::vector<double>& u) {
    return std::vector{numbers("u at each pixel", u, bound, "texel")};
  };
  return {.where = input.what,
          .restated =
              fmt::format("{}, a division every {}; number x is at x + 1/2\nglassbox study run D-4",
                          line_text(line), input.every),
          .expected = expected(values),
          .slipped = {{"half-pixel", expected(at_borders)}, {"affine", expected(even)}}};
}

// 1/w and u at a border of a pixel in double. The relative error of 1/w is 2 u53 and the error of u
// is 6 u53 |u|: u/w rounds three times, and the quotient of the two rounds.
struct SpanPoint {
  double q, u;
};

SpanPoint span_point(const Line& line, int x) {
  const double near = line.pixels - x, far = x;
  const double q = near * line.inverse_w0 + far * line.inverse_w1;
  return {q / line.pixels,
          (near * (line.inverse_w0 * line.u0) + far * (line.inverse_w1 * line.u1)) / q};
}

// The values in double have an error of 9 u53 |u|: 6 from the ends of the span (2 if these are the
// ends of the line), and three roundings. That is at most half of the bound, which is at least 18
// u53 |u| for one pixel and 20 u53 |u| for more, as judge_nearly() needs it.
bool right_span(const SpanCase& input, const Answer& answer) {
  const Line& line = input.line;
  const double bound = 2 * (line.pixels + 8) * u53 * scale_of(line);
  std::vector<double> nearly;
  for (int first = 0; first < line.pixels; first += input.every) {
    const int end = std::min(first + input.every, line.pixels), length = end - first;
    const double start = span_point(line, first).u, last = span_point(line, end).u;
    for (int x = first; x < end; ++x) {
      const double past = x - first + 0.5;
      nearly.push_back(((length - past) * start + past * last) / length);
    }
  }
  const auto judged = judge_nearly(nearly, bound, find_field(answer, "u at each pixel"));
  return judged ? *judged : !judge_case(expect_span(input), answer);
}

// The largest error of linear interpolation in any span, by the law of task 8.3: |du| (sqrt r - 1)
// / (sqrt r + 1).
Decimal largest_span_error(const Line& line, int every) {
  Decimal largest;
  for (int first = 0; first < line.pixels; first += every) {
    const ExactSpanPoint a = exact_span_point(line, first);
    const ExactSpanPoint b = exact_span_point(line, std::min(first + every, line.pixels));
    const Rational r = a.q < b.q ? b.q / a.q : a.q / b.q;
    const Decimal root = sqrt(decimal_from(r));
    const Decimal error = decimal_from(abs(b.u - a.u)) * (root - Decimal(1)) / (root + Decimal(1));
    if (largest < error) largest = error;
  }
  return largest;
}

// The bound 64 R u53 |u| (u53 = 2^-53) of the error |du| (sqrt r - 1) / (sqrt r + 1). du is the
// difference of two coordinates with errors of 8 R u53 |u| each. r has a relative error of 16 R
// u53, and its square root half of that. The quotient gets at most half of the root's error,
// because sqrt r + 1 is at least 2. If u0 = u1, the error is exactly 0.
double choice_bound(const Line& line) {
  return line.u0 == line.u1 ? 0 : 64 * u53 * scale_of(line);
}

std::vector<Expected> choice_fields(const Line& line, int every, double error) {
  // A division in every pixel has no error.
  return {numbers("pixels between two divisions", {double(every)}),
          numbers("error", {error}, every == 1 ? 0 : choice_bound(line), "texel")};
}

// The errors of spans of 2, 4, 8, ... pixels never decrease, because each span is a part of one of
// the next length, over which both du and r are at least as large. So the first error above the
// tolerance ends the search. If an error is within the bound of the tolerance, the search may end
// there or go on: all answers that this allows are right. Without a bound (u0 = u1) no error is
// above the tolerance, even if both are 0.
Case expect_choice(const ChoiceCase& input) {
  const Line& line = input.line;
  const Decimal tolerance(input.tolerance), bound(choice_bound(line));
  std::vector<std::vector<Expected>> right;
  std::vector<Expected> expected = choice_fields(line, 1, 0);
  bool above = false, surely_above = false;
  int every = 1;
  double error = 0;
  std::string text =
      fmt::format("{}; at most {} texels\nthe law:", line_text(line), input.tolerance);
  for (int length = 2; length <= line.pixels; length *= 2) {
    const Decimal of_length = largest_span_error(line, length);
    text += fmt::format(" {} pixels {:.4g}{}", length, double(of_length),
                        2 * length <= line.pixels ? "," : "");
    if (surely_above) continue;
    // The length before this one is a right answer if this length may count as above.
    if (input.line.u0 != input.line.u1 && !(of_length < tolerance - bound))
      right.push_back(choice_fields(line, every, error));
    surely_above = tolerance + bound < of_length;
    if (surely_above) continue;
    every = length;
    error = double(of_length);
    above = above || tolerance < of_length;
    if (!above) expected = choice_fields(line, every, error);
  }
  if (!surely_above) right.push_back(choice_fields(line, every, error));
  Case made{fmt::format("at most {} texels", input.tolerance), text, expected};
  if (right.size() > 1)
    made.judge = [right, expected](const Answer& answer) -> std::optional<Divergence> {
      for (const std::vector<Expected>& each : right) {
        if (!judge_case({.where = "", .restated = "", .expected = each}, answer))
          return std::nullopt;
      }
      return judge_case({.where = "", .restated = "", .expected = expected}, answer);
    };
  return made;
}

// The law's error in double. du has an error of 13 u53 |u| and r one of 5 u53 of itself, so the
// quotient of the roots one of 5 u53; du is at most 2 |u|. With the product's rounding that is 25
// u53 |u|, less than half of the bound.
double nearly_largest_error(const Line& line, int every) {
  double largest = 0;
  SpanPoint a = span_point(line, 0);
  for (int first = 0; first < line.pixels; first += every) {
    const SpanPoint b = span_point(line, std::min(first + every, line.pixels));
    const double root = std::sqrt(a.q < b.q ? b.q / a.q : a.q / b.q);
    largest = std::max(largest, std::abs(b.u - a.u) * ((root - 1) / (root + 1)));
    a = b;
  }
  return largest;
}

// Judges in double. Where an error that is off by half of the bound could decide, exact numbers do.
bool right_choice(const ChoiceCase& input, const Answer& answer) {
  const Line& line = input.line;
  const double bound = choice_bound(line);
  const double error = number_in(answer, "error");
  const double given = number_in(answer, "pixels between two divisions");
  if (!(given >= 1 && given <= line.pixels) || given != std::floor(given)) return false;
  const int every = int(given);
  if ((every & (every - 1)) != 0 || (every == 1 && error != 0)) return false;
  if (line.u0 == line.u1) return error == 0 && 2 * every > line.pixels;
  bool sure = true;
  if (every > 1) {
    const double right = nearly_largest_error(line, every);
    const double distance = std::abs(error - right), above = right - input.tolerance;
    if (!(distance <= 2 * bound) || above > 2 * bound) return false;
    sure = distance <= bound / 2 && above <= bound / 2;
  }
  if (2 * every <= line.pixels) {
    const double below = input.tolerance - nearly_largest_error(line, 2 * every);
    if (below > 2 * bound) return false;
    sure = sure && below <= bound / 2;
  }
  return sure || !judge_case(expect_choice(input), answer);
}

// ---- footprints ----

// The input for the wrong answer "affine", which takes u and v as linear over the screen. They are
// linear if 1/w is 1 at all vertices.
FootprintCase without_perspective(FootprintCase input) {
  for (TexturedVertex& vertex : input.triangle) vertex.inverse_w = 1;
  return input;
}

// The derivatives along screen x and y of an attribute N / D, with N = sum E_k q_k a_k and D = sum
// E_k q_k. For vertex k, E_k is the edge function, q_k is 1/w and a_k the attribute. The quotient
// rule gives (N/D)' = (N' - (N/D) D') / D.
struct ExactGradient {
  Rational along_x, along_y;
};

using Attribute = double TexturedVertex::*;

ExactGradient exact_gradient(const FootprintCase& input, Attribute attribute) {
  Rational n, d, nx, ny, dx, dy;
  for (std::size_t k = 0; k < 3; ++k) {
    const TexturedVertex& vertex = input.triangle[k];
    const TexturedVertex& from = input.triangle[(k + 1) % 3];
    const TexturedVertex& to = input.triangle[(k + 2) % 3];
    const Rational ex = Rational(from.y) - Rational(to.y), ey = Rational(to.x) - Rational(from.x);
    const Rational e =
        ex * (Rational(input.x) - Rational(from.x)) + ey * (Rational(input.y) - Rational(from.y));
    const Rational q(vertex.inverse_w), p = q * Rational(vertex.*attribute);
    n += e * p, nx += ex * p, ny += ey * p;
    d += e * q, dx += ex * q, dy += ey * q;
  }
  return {(nx - n / d * dx) / d, (ny - n / d * dy) / d};
}

// The bound 2048 k^2 (U/e) u of task 8.4: U is the largest |attribute|, e the longer side of the
// bounding box, u the unit roundoff of double, and k is computed below. Let the largest 1/w be 1
// and s = e^2 / area. P = attribute/w and Q = 1/w are planes over the screen. The slope of a plane
// has an error of 20 u s / e, and its value at the pixel one of 48 u s, which is 48 u k relative to
// Q there. The terms of the derivative (P' - (P/Q) Q') / Q are at most 4 k U / e each, where U is
// doubled because coordinates may be taken relative to vertex 0. With the errors of P/Q, Q' and
// 1/Q, that gives 1600 k^2 (U/e) u.
double gradient_bound(const FootprintCase& input, Attribute attribute) {
  const auto& [a, b, c] = input.triangle;
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  const double e = std::max(right - left, bottom - top);
  const double area = std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
  double q = 0;
  const TexturedVertex* vertices[3] = {&a, &b, &c};
  for (std::size_t k = 0; k < 3; ++k) {
    const TexturedVertex& from = *vertices[(k + 1) % 3];
    const TexturedVertex& to = *vertices[(k + 2) % 3];
    q += std::abs((from.y - to.y) * (input.x - from.x) + (to.x - from.x) * (input.y - from.y)) /
         area * vertices[k]->inverse_w;
  }
  const double k = e * e / area * std::max({a.inverse_w, b.inverse_w, c.inverse_w}) / q;
  const double largest =
      std::max({std::abs(a.*attribute), std::abs(b.*attribute), std::abs(c.*attribute)});
  return 2048 * k * k * largest / e * u53;
}

struct ExpectedFootprint {
  std::vector<Expected> fields;
  double along_x = 0, along_y = 0;  // texels per pixel
};

ExpectedFootprint footprint_of(const FootprintCase& input) {
  const ExactGradient u = exact_gradient(input, &TexturedVertex::u);
  const ExactGradient v = exact_gradient(input, &TexturedVertex::v);
  const double u_bound = gradient_bound(input, &TexturedVertex::u);
  const double v_bound = gradient_bound(input, &TexturedVertex::v);
  const double along_x =
      std::hypot(input.width * double(u.along_x), input.height * double(v.along_x));
  const double along_y =
      std::hypot(input.width * double(u.along_y), input.height * double(v.along_y));
  const double longer = std::max(along_x, along_y);
  const double last = std::log2(double(std::max(input.width, input.height)));
  const auto level_of = [last](double length) {
    return length <= 1 ? 0 : std::min(std::log2(length), last);
  };
  // The level may be off by as much as the length's error changes it. The roundings of the lengths
  // and of the logarithm are added.
  const double of_length = std::hypot(input.width * u_bound, input.height * v_bound);
  const double level = level_of(longer);
  const double level_bound =
      std::max(level_of(longer + of_length) - level, level - level_of(longer - of_length)) +
      16 * u53 * last;
  return {{numbers("du/dx, du/dy", {double(u.along_x), double(u.along_y)}, u_bound, "per px"),
           numbers("dv/dx, dv/dy", {double(v.along_x), double(v.along_y)}, v_bound, "per px"),
           numbers("level", {level}, level_bound, "levels")},
          along_x,
          along_y};
}

Case expect_footprint(const FootprintCase& input) {
  const ExpectedFootprint expected = footprint_of(input);
  std::string text;
  for (const TexturedVertex& t : input.triangle)
    text +=
        fmt::format("({}, {}) px: 1/w {}, (u, v) = ({}, {})\n", t.x, t.y, t.inverse_w, t.u, t.v);
  text +=
      fmt::format("at ({}, {}), {} x {} texels: {:.6g} texels to a pixel along x, {:.6g} along y",
                  input.x, input.y, input.width, input.height, expected.along_x, expected.along_y);
  return {.where = input.what,
          .restated = text,
          .expected = expected.fields,
          .slipped = {{"affine", footprint_of(without_perspective(input)).fields}}};
}

// A derivative (N' - (N/D) D') / D in double. The edge functions and their slopes are exact: they
// are multiples of 2^-16 below 2^34. N and D have errors of 4 u U D and 3 u D (U: the largest
// |attribute|, u: the unit roundoff), and N' and D' of 8 u and 6 u times e q U and e q (e: the
// longer side of the bounding box, q: the largest 1/w). Together that is 52 u k U / e, with k of
// the bound, which is 1 at least: a thirty-ninth of the bound.
std::vector<double> nearly_gradient(const FootprintCase& input, Attribute attribute) {
  double n = 0, d = 0, nx = 0, ny = 0, dx = 0, dy = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const TexturedVertex& vertex = input.triangle[k];
    const TexturedVertex& from = input.triangle[(k + 1) % 3];
    const TexturedVertex& to = input.triangle[(k + 2) % 3];
    const double ex = from.y - to.y, ey = to.x - from.x;
    const double e = ex * (input.x - from.x) + ey * (input.y - from.y);
    const double q = vertex.inverse_w, p = q * vertex.*attribute;
    n += e * p, nx += ex * p, ny += ey * p;
    d += e * q, dx += ex * q, dy += ey * q;
  }
  return {(nx - n / d * dx) / d, (ny - n / d * dy) / d};
}

bool right_footprint(const FootprintCase& input, const Answer& answer) {
  const auto u = nearly_gradient(input, &TexturedVertex::u);
  const auto v = nearly_gradient(input, &TexturedVertex::v);
  const double u_bound = gradient_bound(input, &TexturedVertex::u);
  const double v_bound = gradient_bound(input, &TexturedVertex::v);
  const auto u_judged = judge_nearly(u, u_bound, find_field(answer, "du/dx, du/dy"));
  const auto v_judged = judge_nearly(v, v_bound, find_field(answer, "dv/dx, dv/dy"));
  if (u_judged == false || v_judged == false) return false;
  const double longer = std::max(std::hypot(input.width * u[0], input.height * v[0]),
                                 std::hypot(input.width * u[1], input.height * v[1]));
  const double of_length = std::hypot(input.width * u_bound, input.height * v_bound);
  const double last = std::log2(double(std::max(input.width, input.height)));
  // The exact length is between `least` and `most`, since the length in double is off by a
  // thirty-ninth of `of_length` at most. The level never decreases with the length, which gives the
  // least and the largest value that its distance and its bound can have. Half of the bound's last
  // term, for roundings, is left for those of this computation.
  const auto level_of = [last](double length) {
    return length <= 1 ? 0 : std::min(std::log2(length), last);
  };
  const double least = longer - of_length / 32, most = longer + of_length / 32;
  const double lowest = level_of(least), highest = level_of(most);
  const double up = level_of(least + of_length) - highest;
  const double down = lowest - level_of(most - of_length);
  const double largest_up = level_of(most + of_length) - lowest;
  const double largest_down = highest - level_of(least - of_length);
  const double level = number_in(answer, "level");
  const double reach = std::max(largest_up, largest_down) + 32 * u53 * last;
  if (!(level >= lowest - reach && level <= highest + reach)) return false;
  const double distance = std::max(std::abs(level - lowest), std::abs(level - highest));
  if (u_judged && v_judged && distance <= std::max({up, down, 0.0}) + 8 * u53 * last) return true;
  return !judge_case(expect_footprint(input), answer);
}

}  // namespace

Lab lab_08() {
  Lab lab{
      8,
      "08-attributes",
      "Attributes: perspective, spans, mip levels, and how finely to cut a surface",
      {{"8.1", "Texture coordinates at a pixel", 25},
       {"8.2", "Coordinates by spans", 15},
       {"8.3", "The longest span within a tolerance", 15},
       {"8.4", "Footprint and mip level", 20},
       {"8.5", "A Bezier patch in triangles", 15},
       {"8.6", "The level of a patch", 10}},
      {check("texture coordinates at a pixel", "8.1", "shading", pixels, expect_pixel),
       generated_check("any pixel", "8.1", "shading", generated_pixels, expect_pixel, right_pixel),
       hidden_check("texture coordinates at other pixels", "8.1", "shading", hidden_pixels,
                    expect_pixel),
       check("coordinates along a row by spans", "8.2", "shading", spans, expect_span),
       generated_check("any row", "8.2", "shading", generated_rows, expect_span, right_span),
       hidden_check("coordinates along other rows", "8.2", "shading", hidden_spans, expect_span),
       check("the longest span within a tolerance", "8.3", "shading", choices, expect_choice),
       generated_check("any row and tolerance", "8.3", "shading", generated_choices, expect_choice,
                       right_choice),
       hidden_check("the longest span of other rows", "8.3", "shading", hidden_choices,
                    expect_choice),
       check("footprint and mip level", "8.4", "shading", footprints, expect_footprint),
       generated_check("any footprint", "8.4", "shading", generated_footprints, expect_footprint,
                       right_footprint),
       hidden_check("other footprints", "8.4", "shading", hidden_footprints, expect_footprint)}};
  for (Check& each : surface_checks()) lab.checks.push_back(std::move(each));
  return lab;
}

}  // namespace glassbox::labs
