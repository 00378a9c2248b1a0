// Compares the arithmetic in which a pixel centre is tested against an edge (D-3).
#include <cmath>
#include <cstdint>

#include "study/experiment/experiment.h"
#include "study/experiments/d03_edges.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace d03 {

// ---- errors ----

bool is_wrong(EdgeArithmetic arithmetic, const EdgeSample& s) {
  return covers_centre(arithmetic, s) != right_decision(s);
}
// Whether both triangles at the edge cover the pixel, or neither of them does.
bool is_leak(EdgeArithmetic arithmetic, const EdgeSample& s) {
  return covers_centre(arithmetic, s) == covers_centre(arithmetic, s.reversed());
}

using Fault = bool (*)(EdgeArithmetic, const EdgeSample&);

double rate(Fault fault, EdgeArithmetic arithmetic, int width, int samples) {
  Random random(3);
  int faults = 0;
  for (int i = 0; i < samples; ++i) faults += fault(arithmetic, random_edge_sample(random, width));
  return double(faults) / samples;
}

// ---- theory ----

// E is the edge function at a pixel centre. The centre is anywhere within half a pixel of its edge
// along the minor axis, so E is anywhere in a range of 256 major. If rounding errors of products
// and sums change E by e, its sign is wrong for a fraction |e| / (256 major) of the centres. A
// RoundingError returns the mean of |e|, divided by the relative rms of a rounding error.
using RoundingError = double (*)(const EdgeSample&);

double product(const EdgeSample& s) {
  return double(s.dx()) * (s.y - s.from.y);
}
double difference_error(const EdgeSample& s) {
  return kMeanOfNormal * std::sqrt(2.0) * std::abs(product(s));
}
double plane_error(const EdgeSample& s) {
  const double a = -double(s.dy()), b = double(s.dx());
  const double p = double(s.from.x) * s.to.y, q = double(s.to.x) * s.from.y;
  const double ax = a * s.x, by = b * s.y;
  return kMeanOfNormal * std::sqrt(square(p) + square(q) + square(p - q) + square(ax) + square(by) +
                                   square(ax + by));
}
// With a fused multiply-add, only one rounding error matters. It is uniformly distributed, so its
// mean size is sqrt(3)/2 of its rms.
double fma_error(const EdgeSample& s) {
  return std::sqrt(0.75) * std::abs(product(s));
}
double exact_error(const EdgeSample&) {
  return 0;
}
// The two triangles at an edge begin their computations at different ends of it, so their errors
// are independent.
double two_sided_difference_error(const EdgeSample& s) {
  return std::sqrt(square(difference_error(s)) + square(difference_error(s.reversed())));
}
double two_sided_fma_error(const EdgeSample& s) {
  return kMeanOfNormal * std::sqrt(square(product(s)) + square(product(s.reversed())));
}

double predict(RoundingError error, int width) {
  Random random(33);
  double sum = 0;
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    const EdgeSample s = random_edge_sample(random, width);
    sum += rms_rounding<float> * error(s) / (double(s.major()) * kSubpixels);
  }
  return sum / kSamples;
}

// ---- the table ----

struct Series {
  EdgeArithmetic arithmetic;
  const char* name;
  RoundingError wrong, leak;
};
constexpr Series kSeries[] = {
    {EdgeArithmetic::kFloatDifference, "float, difference form", difference_error,
     two_sided_difference_error},
    {EdgeArithmetic::kFloatPlane, "float, plane form", plane_error, exact_error},
    {EdgeArithmetic::kFloatFma, "float, difference form with FMA", fma_error, two_sided_fma_error},
    {EdgeArithmetic::kDouble, "double", exact_error, exact_error},
    {EdgeArithmetic::kInt32Tile, "int32, relative to the tile", exact_error, exact_error},
    {EdgeArithmetic::kInt64, "int64", exact_error, exact_error},
};

void add_series(std::vector<Configuration>& all, const Series& series, int width, Effort effort) {
  const int samples = effort == Effort::kFull ? 15'000'000 : 2'000'000;
  constexpr int kTimed = 500;
  const EdgeArithmetic arithmetic = series.arithmetic;
  const auto work = [arithmetic, triangles = timed_triangles(width, kTimed)](int) {
    do_not_optimize(count_covered(arithmetic, triangles));
  };
  const auto add = [&](const char* scene, Fault fault, RoundingError theory) {
    all.push_back({.series = series.name,
                   .parameter = double(width),
                   .scene = scene,
                   .error = [=] { return rate(fault, arithmetic, width, samples); },
                   .predicted_error = predict(theory, width),
                   .work = work,
                   .items = double(kTimed) * kEdgeTile * kEdgeTile});
  };
  add("wrong decisions", is_wrong, series.wrong);
  add("gaps and doubles", is_leak, series.leak);
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  for (const Series& series : kSeries) {
    for (const int width : {1920, 7680, 32768}) add_series(all, series, width, effort);
  }
  return all;
}

}  // namespace d03

Experiment d03_edge_arithmetic() {
  using namespace d03;
  return {
      .id = "D-3",
      .name = "Coverage: the arithmetic of edge functions",
      .question =
          "How often do rounded edge functions give a pixel to the wrong triangle, to both or to "
          "neither?",
      .axis = "width of the screen",
      .axis_unit = "px",
      .error = "fraction of pixel centres within half a pixel of an edge that are decided wrongly",
      .reference = "128-bit integers, vertices snapped to 1/256 px",
      .theory =
          "The fraction is the mean of |error of the edge function| / (longer side of the edge * 1 "
          "px), where each rounding error counts as random, 0.42 u (u = 2^-24). The difference "
          "form rounds two products of equal size (0.048 u W on average, where W is the width of "
          "the screen), and only one with FMA; the plane form rounds three products and three sums "
          "as large as the screen. If the direction of the edge is reversed, the plane form only "
          "changes its sign: it is wrong, but leaves no gap. Integers are exact, and so are "
          "doubles, which have 53 bits for values of 50 bits",
      .item = "pixel",
      .configurations = configurations};
}

}  // namespace glassbox::study
