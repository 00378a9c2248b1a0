// D-4: where the perspective divide is done, and how well.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "study/experiment/experiment.h"
#include "study/experiments/consume.h"
#include "study/experiments/kernels/reciprocal_kernels.h"
#include "study/experiments/reciprocal_table.h"
#include "study/experiments/rounding_model.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace {

// u runs over 256 texels along 256 pixels, one texel to a pixel on average, up to a random shift of the wall; w grows
// `ratio`-fold from end to end.
constexpr double kTexels = kLinePixels;

std::vector<PerspectiveLine> random_lines(double ratio, int count) {
  Random random(5);
  std::vector<PerspectiveLine> lines;
  for (int i = 0; i < count; ++i) {
    const double near = random.between(1, 2);
    lines.push_back(
        {0, float(kTexels - random.unit()), float(1 / near), float(1 / (near * ratio))});
  }
  return lines;
}

// ---- the ways ----

struct Screen {  // 1/w and u/w at a place along the line, 0 .. 1
  float q, p;
};
Screen at(const PerspectiveLine& line, float far) {
  const float near = 1.0f - far;
  return {near * line.inverse_w0 + far * line.inverse_w1,
          near * (line.u0 * line.inverse_w0) + far * (line.u1 * line.inverse_w1)};
}

// 0: the whole line.
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

// u at the centre of pixel x.
float by_pixel(Perspective method, const PerspectiveLine& line, int x) {
  const auto [q, p] = at(line, (float(x) + 0.5f) * (1.0f / kLinePixels));
  if (method == Perspective::kDivide) return p / q;
  const float w = approximate_reciprocal(q);
  return p * (method == Perspective::kNewton ? newton_reciprocal(q, w) : w);
}
float by_span(int span, const PerspectiveLine& line, int x) {
  const int first = x / span * span;
  const auto edge = [&](int pixel) {
    const auto [q, p] = at(line, float(pixel) * (1.0f / kLinePixels));
    return p / q;
  };
  const float start = first == 0 ? line.u0 : edge(first);
  const float step = (edge(first + span) - start) * (1.0f / float(span));
  return start + (float(x - first) + 0.5f) * step;
}
float coordinate(Perspective method, const PerspectiveLine& line, int x) {
  const int span = span_of(method);
  return span == 1 ? by_pixel(method, line, x) : by_span(span, line, x);
}

// ---- the error ----

// In double, whose own error is 2^-29 of float's.
double exact_coordinate(const PerspectiveLine& line, double far) {
  const double q0 = line.inverse_w0, q1 = line.inverse_w1;
  return ((1 - far) * (line.u0 * q0) + far * (line.u1 * q1)) / ((1 - far) * q0 + far * q1);
}

double largest_error(Perspective method, double ratio, int lines) {
  double largest = 0;
  for (const PerspectiveLine& line : random_lines(ratio, lines)) {
    for (int x = 0; x < kLinePixels; ++x) {
      const double right = exact_coordinate(line, (x + 0.5) / kLinePixels);
      largest = std::max(largest, std::abs(coordinate(method, line, x) - right));
    }
  }
  return largest;
}

// ---- the theory ----

// Float, for the largest u, that of the last pixel's centre: u/w is rounded as a product at the vertex and again times its
// share; 1/w has two products and a sum; the division (or product) is the last. Six roundings of rms 0.42 u, of which the
// largest of a few hundred is about three times the rms.
double largest_coordinate(double ratio) {
  return exact_coordinate({0, float(kTexels), 1, float(1 / ratio)}, 1 - 0.5 / kLinePixels);
}
double of_roundings(double ratio) {
  return 3 * std::sqrt(6.0) * rms_rounding<float> * largest_coordinate(ratio);
}

// Linear interpolation over a span errs by |du| (sqrt r - 1)/(sqrt r + 1) where 1/w changes r-fold in it.
double of_span(double r, double du) {
  return std::abs(du) * (std::sqrt(r) - 1) / (std::sqrt(r) + 1);
}
double of_spans(double ratio, int span) {
  const PerspectiveLine line{0, float(kTexels), 1, float(1 / ratio)};
  double largest = 0;
  for (int x = 0; x < kLinePixels; x += span) {
    const double start = double(x) / kLinePixels, end = double(x + span) / kLinePixels;
    const auto q = [&](double far) { return (1 - far) + far / ratio; };
    largest = std::max(largest, of_span(q(start) / q(end), exact_coordinate(line, end) -
                                                               exact_coordinate(line, start)));
  }
  return largest;
}

double predict(Perspective method, double ratio) {
  switch (method) {
    case Perspective::kDivide:
      return of_roundings(ratio);
    case Perspective::kApproximate:
      return kReciprocalError * largest_coordinate(ratio);
    case Perspective::kNewton:
      // Newton's step always errs downwards, by the square; its own two roundings are of the kind of the others.
      return square(kReciprocalError) * largest_coordinate(ratio) + of_roundings(ratio);
    default:
      return of_spans(ratio, span_of(method)) + of_roundings(ratio);
  }
}

// ---- the table ----

struct Series {
  Perspective method;
  const char* name;
};
constexpr Series kSeries[] = {
    {Perspective::kDivide, "a division for each pixel"},
    {Perspective::kNewton, "approximate reciprocal and a Newton step"},
    {Perspective::kApproximate, "approximate reciprocal"},
    {Perspective::kEvery8, "a division every 8 pixels"},
    {Perspective::kEvery16, "a division every 16 pixels"},
    {Perspective::kEvery32, "a division every 32 pixels"},
    {Perspective::kAffine, "none: affine"},
};

std::vector<Configuration> configurations(Effort effort) {
  const int lines = effort == Effort::kFull ? 1000 : 100;
  constexpr int kTimed = 250, kRounds = 16;
  std::vector<std::int32_t> texture(kLinePixels);
  std::iota(texture.begin(), texture.end(), 0);
  std::vector<Configuration> all;
  for (const Series& series : kSeries) {
    const Perspective method = series.method;
    for (const double ratio : {1.01, 1.41, 2.0, 5.0, 10.0, 30.0, 100.0}) {
      all.push_back(
          {.series = series.name,
           .parameter = ratio,
           .error = [=] { return largest_error(method, ratio, lines); },
           .predicted_error = predict(method, ratio),
           .work =
               [method, texture, walls = random_lines(ratio, kTimed),
                out = std::vector<std::int32_t>(std::size_t(kTimed) * kLinePixels)](int) mutable {
                 for (int round = 0; round < kRounds; ++round) {
                   draw_lines(method, walls, texture, out);
                   consume(out.back());
                 }
               },
           .items = double(kTimed) * kLinePixels * kRounds});
    }
  }
  return all;
}

}  // namespace

Experiment d04_perspective() {
  return {.id = "D-4",
          .name = "Perspective: where the divide is done",
          .question =
              "How wrong are texture coordinates when the divide is approximated, or done only now "
              "and then?",
          .axis = "w at the far end of a line of 256 pixels over w at its near end",
          .error = "largest error of u at a pixel centre, of 256 texels along the line",
          .error_unit = "texel",
          .reference = "the same interpolation in double",
          .theory =
              "|du| (sqrt r - 1)/(sqrt r + 1) over a span in which w grows r-fold and u by du "
              "(exact; B.11), the largest of the line's spans; for an approximate reciprocal u "
              "times 2^-12 + 2^-14 (the table's bound, 2^-11.7), its square after a Newton step; "
              "six roundings of float otherwise. Errors are those of a table that stands for the "
              "instruction, which differs between processors; times are the instruction's",
          .item = "pixel",
          .configurations = configurations};
}

}  // namespace glassbox::study
