// Compares where the perspective divide is done, and how accurate the result is (D-4).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "study/experiment/experiment.h"
#include "study/experiments/d04_lines.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/kernels/reciprocal_kernels.h"
#include "study/experiments/memoize.h"
#include "study/experiments/reciprocal_table.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace d04 {

// ---- the methods ----

struct Screen {  // 1/w and u/w at a fraction of the line, 0 .. 1
  float q, p;
};
Screen at(const PerspectiveLine& line, float far) {
  const float near = 1.0f - far;
  return {near * line.inverse_w0 + far * line.inverse_w1,
          near * (line.u0 * line.inverse_w0) + far * (line.u1 * line.inverse_w1)};
}

// The length of a span (from one division to the next) in pixels; 1: a division for each pixel.
int span_of(Perspective method) {
  switch (method) {
    case Perspective::kEvery8:
      return 8;
    case Perspective::kEvery16:
      return 16;
    case Perspective::kEvery32:
      return 32;
    case Perspective::kAffine:
      return kLinePixels;
    default:
      return 1;
  }
}

// The texture coordinate u at the centre of pixel x.
float by_pixel(Perspective method, const PerspectiveLine& line, int x) {
  const auto [q, p] = at(line, (float(x) + 0.5f) * (1.0f / float(line.pixels)));
  if (method == Perspective::kDivide) return p / q;
  const float w = approximate_reciprocal(q);
  return p * (method == Perspective::kNewton ? newton_reciprocal(q, w) : w);
}
float by_span(int span, const PerspectiveLine& line, int x) {
  const int first = x / span * span, length = std::min(span, line.pixels - first);
  const auto edge = [&](int pixel) {
    const auto [q, p] = at(line, float(pixel) * (1.0f / float(line.pixels)));
    return p / q;
  };
  const float start = first == 0 ? line.u0 : edge(first);
  const float step = (edge(first + length) - start) * (1.0f / float(length));
  return start + (float(x - first) + 0.5f) * step;
}
float coordinate(Perspective method, const PerspectiveLine& line, int x) {
  const int span = span_of(method);
  return span == 1 ? by_pixel(method, line, x) : by_span(span, line, x);
}

// ---- the error ----

struct Errors {
  double largest = 0, rms = 0;  // in texels
};

Errors errors_of(Perspective method, const Lines& lines) {
  Errors errors;
  double squares = 0, pixels = 0;
  for (const PerspectiveLine& line : lines) {
    for (int x = 0; x < line.pixels; ++x) {
      const double right = exact_coordinate(line, (x + 0.5) / line.pixels);
      const double error = std::abs(double(coordinate(method, line, x)) - right);
      errors.largest = std::max(errors.largest, error);
      squares += square(error);
    }
    pixels += line.pixels;
  }
  errors.rms = std::sqrt(squares / pixels);
  return errors;
}

// ---- the theory, for one line: the largest error and the mean square ----

struct Predicted {
  double largest = 0, square = 0;
};

// The largest |u| and the mean square of u at the pixels' centres, because errors are relative to
// u.
Predicted coordinates(const PerspectiveLine& line) {
  Predicted u;
  for (int x = 0; x < line.pixels; ++x) {
    const double at = exact_coordinate(line, (x + 0.5) / line.pixels);
    u.largest = std::max(u.largest, std::abs(at));
    u.square += square(at) / line.pixels;
  }
  return u;
}

// In float, u/w is rounded as a product at the vertex and again when it is multiplied by its
// weight; 1/w has two products and a sum; the division (or product) is the last operation. This
// gives six rounding errors, each with an rms of 0.42 units roundoff; the largest of a few hundred
// errors is about three times the rms.
Predicted predict_roundings(const Predicted& u) {
  return {3 * std::sqrt(6.0) * rms_rounding<float> * u.largest,
          6 * square(rms_rounding<float>) * u.square};
}

// The error of a reciprocal from the table (reciprocal_table.h): up to 2^-12 because one entry
// serves an interval, and up to 2^-14 because the entry is rounded. Both are uniformly distributed,
// so their mean squares are a third of the squared bounds.
Predicted predict_table(const Predicted& u) {
  return {kReciprocalError * u.largest, (square(0x1p-12) + square(0x1p-14)) / 3 * u.square};
}

// After a step of Newton's method, the relative error is the square of the previous one and always
// negative: at most 2^-24. For a uniformly distributed error, the mean fourth power is 1/5 of the
// largest.
Predicted predict_newton(const Predicted& u) {
  return {square(kReciprocalError) * u.largest, square(0x1p-24) / 5 * u.square};
}

// Linear interpolation over a span in which 1/w changes by the factor r, and u by du, has the error
// |du| (t - t/(t + (1 - t) r)) at the fraction t of the span. Its largest value is |du| (sqrt r -
// 1)/(sqrt r + 1); its mean square is the integral of its square over t, with a = r - 1. For r near
// 1 the error is nearly a parabola in t.
Predicted predict_span(double ratio, double du) {
  const double r = std::max(ratio, 1 / ratio), a = r - 1;
  const double largest = std::abs(du) * (std::sqrt(r) - 1) / (std::sqrt(r) + 1);
  if (a < 0.05) return {largest, square(largest) * 8 / 15};
  const double a3 = a * a * a;
  // the integral of t times t/(t + (1 - t) r)
  const double product = r * r * std::log(r) / a3 - r / (a * a) - 1 / (2 * a);
  const double other = (r * r - 1 - 2 * r * std::log(r)) / a3;
  return {largest, square(du) * (1.0 / 3 - 2 * product + other)};
}
Predicted predict_spans(const PerspectiveLine& line, int span) {
  Predicted all;
  for (int x = 0; x < line.pixels; x += span) {
    const int length = std::min(span, line.pixels - x);
    const double start = double(x) / line.pixels, end = double(x + length) / line.pixels;
    const auto q = [&](double far) {
      return (1 - far) * double(line.inverse_w0) + far * double(line.inverse_w1);
    };
    const Predicted one = predict_span(q(start) / q(end),
                                       exact_coordinate(line, end) - exact_coordinate(line, start));
    all.largest = std::max(all.largest, one.largest);
    all.square += one.square * length / line.pixels;
  }
  return all;
}

Predicted operator+(const Predicted& a, const Predicted& b) {
  return {a.largest + b.largest, a.square + b.square};
}

Predicted predict(Perspective method, const PerspectiveLine& line) {
  const Predicted u = coordinates(line);
  switch (method) {
    case Perspective::kDivide:
      return predict_roundings(u);
    case Perspective::kApproximate:
      return predict_table(u);
    case Perspective::kNewton:
      return predict_newton(u) + predict_roundings(u);
    default:
      return predict_spans(line, span_of(method)) + predict_roundings(u);
  }
}

Errors predict(Perspective method, const Lines& lines) {
  Errors errors;
  double squares = 0, pixels = 0;
  for (const PerspectiveLine& line : lines) {
    const Predicted one = predict(method, line);
    errors.largest = std::max(errors.largest, one.largest);
    squares += one.square * line.pixels;
    pixels += line.pixels;
  }
  errors.rms = std::sqrt(squares / pixels);
  return errors;
}

// ---- the table ----

struct Series {
  Perspective method;
  const char* name;
};
constexpr const char* kRms = "root mean square";
constexpr Series kSeries[] = {
    {Perspective::kDivide, "a division for each pixel"},
    {Perspective::kNewton, "approximate reciprocal and a Newton step"},
    {Perspective::kApproximate, "approximate reciprocal"},
    {Perspective::kEvery8, "a division every 8 pixels"},
    {Perspective::kEvery16, "a division every 16 pixels"},
    {Perspective::kEvery32, "a division every 32 pixels"},
    {Perspective::kAffine, "none: affine"},
};

std::function<void(int)> work_of(Perspective method, const Lines& lines, int rounds) {
  std::vector<std::int32_t> texture(kLinePixels);
  std::iota(texture.begin(), texture.end(), 0);
  return [=, out = std::vector<std::int32_t>(lines.size() * kLinePixels)](int) mutable {
    for (int round = 0; round < rounds; ++round) {
      draw_lines(method, lines, texture, out);
      do_not_optimize(out.back());
    }
  };
}

void add_lines(const std::string& scene, const Lines& lines, double parameter,
               std::vector<Configuration>& all) {
  constexpr int kTimed = 250, kRounds = 16;
  const Lines timed = subsample_lines(lines, kTimed);
  double pixels = 0;
  for (const PerspectiveLine& line : timed) pixels += line.pixels;
  for (const Series& series : kSeries) {
    const Perspective method = series.method;
    const auto errors = memoize([=] { return errors_of(method, lines); });
    const Errors predicted = predict(method, lines);
    all.push_back({.series = series.name,
                   .parameter = parameter,
                   .scene = scene,
                   .error = [=] { return errors().largest; },
                   .predicted_error = predicted.largest,
                   .work = work_of(method, timed, kRounds),
                   .items = pixels * kRounds});
    all.push_back({.series = series.name,
                   .parameter = parameter,
                   .scene = scene,
                   .measure = kRms,
                   .error = [=] { return errors().rms; },
                   .predicted_error = predicted.rms});
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  for (const double ratio : {1.01, 1.41, 2.0, 5.0, 10.0, 30.0, 100.0})
    add_lines("wall", wall(ratio, effort == Effort::kFull ? 1000 : 100), ratio, all);
  const Lines floor = rolled_floor(), pot = teapot();
  add_lines("floor, rolled by 22.5 degrees", floor, largest_ratio(floor), all);
  add_lines("teapot", pot, largest_ratio(pot), all);
  return all;
}

}  // namespace d04

Experiment d04_perspective() {
  using namespace d04;
  return {.id = "D-4",
          .name = "Perspective: how often the divide is done",
          .question =
              "How wrong are texture coordinates if the divide is approximated, or done only every "
              "few pixels?",
          .axis =
              "w at the far end of a line of 256 pixels divided by w at its near end; for the "
              "floor and the teapot, the largest such ratio of a row",
          .error =
              "largest error of u at a pixel centre, with 256 texels along the line; on the floor "
              "and the teapot, in texels of the mip level that fits each row",
          .error_unit = "texel",
          .reference = "the same interpolation in double",
          .theory =
              "|du| (sqrt r - 1)/(sqrt r + 1) over a span in which w grows r-fold and u by du "
              "(exact; B.11 in docs/references.md): the largest over the line's spans, and the "
              "integral of its square. Approximate reciprocal: u times 2^-12 + 2^-14 (the table's "
              "bound, 2^-11.7), and its square after a Newton step. Otherwise: six rounding errors "
              "of float. Errors are those of a table, because the instruction differs between "
              "processors; times are those of the instruction",
          .item = "pixel",
          .measures = {{kRms, "root mean square error of u over the pixel centres", "texel"}},
          .configurations = configurations};
}

}  // namespace glassbox::study
