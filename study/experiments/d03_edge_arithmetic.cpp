// D-3: in which arithmetic a pixel centre is compared with an edge.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <glassbox/raster/stages.h>

#include "study/experiments/consume.h"
#include "study/experiments/experiments.h"
#include "study/experiments/kernels/edge_kernels.h"
#include "study/experiments/rounding_model.h"
#include "study/random.h"

namespace glassbox::study {
namespace {

// ---- an edge, and a pixel centre within half a pixel of it ----

struct Sample {
  SnappedVertex from, to;
  std::int32_t x = 0, y = 0;  // the centre, in 1/256 px

  Sample reversed() const { return {to, from, x, y}; }
  std::int64_t dx() const { return to.x - from.x; }
  std::int64_t dy() const { return to.y - from.y; }
  // The longer side of the edge's box: |E| over it is the distance along the other axis.
  std::int64_t major() const { return std::max(std::abs(dx()), std::abs(dy())); }
  // Top and left edges own their points, as in the pipeline.
  bool owns_zero() const { return dy() < 0 || (dy() == 0 && dx() > 0); }
};

std::int32_t nearest_centre(std::int64_t subpixels) {
  return std::int32_t((subpixels & ~std::int64_t(kSubpixels - 1)) + kPixelCentre);
}

// Ends anywhere in a square of `width` px; a pixel of a random row or column that the edge crosses.
Sample random_sample(Random& random, int width) {
  const std::int64_t side = std::int64_t(width) * kSubpixels - 1;
  const auto anywhere = [&] { return std::int32_t(random.integer(0, side)); };
  while (true) {
    Sample s{{anywhere(), anywhere()}, {anywhere(), anywhere()}};
    if (s.major() < kSubpixels) continue;
    const double t = random.unit();
    if (std::abs(s.dx()) == s.major()) {
      s.x = nearest_centre(s.from.x + std::int64_t(t * double(s.dx())));
      s.y = nearest_centre(s.from.y + (s.x - s.from.x) * s.dy() / s.dx());
    } else {
      s.y = nearest_centre(s.from.y + std::int64_t(t * double(s.dy())));
      s.x = nearest_centre(s.from.x + (s.y - s.from.y) * s.dx() / s.dy());
    }
    return s;
  }
}

// ---- the ways ----

// E = dx (y - y0) - dy (x - x0), exact: the factors have 24 bits.
std::int64_t exact_edge(const Sample& s) {
  return s.dx() * (s.y - s.from.y) - s.dy() * (s.x - s.from.x);
}

template <class T>
bool covers(T edge, const Sample& s) {
  return edge > 0 || (edge == 0 && s.owns_zero());
}

// All coordinates and their differences are floats exactly.
float float_difference(const Sample& s) {
  const float right = float(s.x) - float(s.from.x), down = float(s.y) - float(s.from.y);
  return float(s.dx()) * down - float(s.dy()) * right;
}
float float_fma(const Sample& s) {
  const float right = float(s.x) - float(s.from.x), down = float(s.y) - float(s.from.y);
  return std::fma(-float(s.dy()), right, float(s.dx()) * down);
}
// c = x0 y1 - x1 y0 changes its sign, and nothing else, when the ends are exchanged.
template <class T>
T plane(const Sample& s) {
  const T a = -T(s.dy()), b = T(s.dx());
  const T c = T(s.from.x) * T(s.to.y) - T(s.to.x) * T(s.from.y);
  return (a * T(s.x) + b * T(s.y)) + c;
}
// Seen from the corner of the tile that the pixel lies in. E - bias >= 0 if and only if its quotient by 256, rounded down, is;
// within a tile of 64 px next to the edge that quotient has less than 2 * 2^23 * 2^6 = 2^30.
std::int32_t int32_tile(const Sample& s) {
  const std::int32_t tile = kEdgeTile * kSubpixels;
  const std::int32_t column = s.x % tile / kSubpixels, row = s.y % tile / kSubpixels;
  Sample corner = s;
  corner.x -= column * kSubpixels, corner.y -= row * kSubpixels;
  const auto start = std::int32_t((exact_edge(corner) - (s.owns_zero() ? 0 : 1)) >> kSubpixelBits);
  return start - std::int32_t(s.dy()) * column + std::int32_t(s.dx()) * row;
}

bool decide(EdgeArithmetic arithmetic, const Sample& s) {
  switch (arithmetic) {
    case EdgeArithmetic::kFloatDifference:
      return covers(float_difference(s), s);
    case EdgeArithmetic::kFloatPlane:
      return covers(plane<float>(s), s);
    case EdgeArithmetic::kFloatFma:
      return covers(float_fma(s), s);
    case EdgeArithmetic::kDouble:
      return covers(plane<double>(s), s);
    case EdgeArithmetic::kInt32Tile:
      return int32_tile(s) >= 0;
    case EdgeArithmetic::kInt64:
      break;
  }
  return covers(exact_edge(s), s);
}

// ---- errors ----

// 128 bits, from the corners as they are.
bool right_decision(const Sample& s) {
  __extension__ using Wide = __int128;
  const Wide e = (Wide(s.to.x) - s.from.x) * (Wide(s.y) - s.from.y) -
                 (Wide(s.to.y) - s.from.y) * (Wide(s.x) - s.from.x);
  return covers(e, s);
}

bool is_wrong(EdgeArithmetic arithmetic, const Sample& s) {
  return decide(arithmetic, s) != right_decision(s);
}
// The triangles on either side both claim the pixel, or neither does.
bool is_leak(EdgeArithmetic arithmetic, const Sample& s) {
  return decide(arithmetic, s) == decide(arithmetic, s.reversed());
}

using Fault = bool (*)(EdgeArithmetic, const Sample&);

double rate(Fault fault, EdgeArithmetic arithmetic, int width, int samples) {
  Random random(3);
  int faults = 0;
  for (int i = 0; i < samples; ++i) faults += fault(arithmetic, random_sample(random, width));
  return double(faults) / samples;
}

// ---- theory ----

// E is off by the roundings of its products and sums. A centre lies anywhere within half a pixel, 256 steps, of its edge
// along the minor axis: the decision is wrong for a share E|error of E| / (major * 256) of them.
using RoundingError =
    double (*)(const Sample&);  // E|error of E|, to be multiplied by the relative rms of a rounding

double product(const Sample& s) {
  return double(s.dx()) * (s.y - s.from.y);
}
double of_difference(const Sample& s) {
  return kMeanOfNormal * std::sqrt(2.0) * std::abs(product(s));
}
double of_plane(const Sample& s) {
  const double a = -double(s.dy()), b = double(s.dx());
  const double p = double(s.from.x) * s.to.y, q = double(s.to.x) * s.from.y;
  const double ax = a * s.x, by = b * s.y;
  return kMeanOfNormal * std::sqrt(square(p) + square(q) + square(p - q) + square(ax) + square(by) +
                                   square(ax + by));
}
// One rounding: evenly spread, mean sqrt(3)/2 of its rms.
double of_fma(const Sample& s) {
  return std::sqrt(0.75) * std::abs(product(s));
}
double of_exact(const Sample&) {
  return 0;
}
// The errors seen from both ends, independent of each other.
double of_differences(const Sample& s) {
  return std::sqrt(square(of_difference(s)) + square(of_difference(s.reversed())));
}
double of_fmas(const Sample& s) {
  return kMeanOfNormal * std::sqrt(square(product(s)) + square(product(s.reversed())));
}

double predict(RoundingError error, int width) {
  Random random(33);
  double sum = 0;
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    const Sample s = random_sample(random, width);
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
    {EdgeArithmetic::kFloatDifference, "float, difference form", of_difference, of_differences},
    {EdgeArithmetic::kFloatPlane, "float, plane form", of_plane, of_exact},
    {EdgeArithmetic::kFloatFma, "float, difference form with FMA", of_fma, of_fmas},
    {EdgeArithmetic::kDouble, "double", of_exact, of_exact},
    {EdgeArithmetic::kInt32Tile, "int32, relative to the tile", of_exact, of_exact},
    {EdgeArithmetic::kInt64, "int64", of_exact, of_exact},
};

// Triangles with a corner in a tile somewhere on a screen that wide.
std::vector<TileEdges> timed_triangles(int width, int count) {
  Random random(4);
  std::vector<TileEdges> triangles;
  const std::int64_t far = std::int64_t(width) * kSubpixels / 2;
  for (int i = 0; i < count; ++i) {
    TileEdges t;
    std::array<std::int32_t, 3> x, y;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t reach = k == 0 ? kEdgeTile * kSubpixels / 2 : far;
      x[k] = std::int32_t(random.integer(-reach, reach));
      y[k] = std::int32_t(random.integer(-reach, reach));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      t.x0[k] = x[k], t.y0[k] = y[k], t.dx[k] = x[next] - x[k], t.dy[k] = y[next] - y[k];
    }
    triangles.push_back(t);
  }
  return triangles;
}

void add_series(std::vector<Configuration>& all, const Series& series, int width, Effort effort) {
  const int samples = effort == Effort::kFull ? 15'000'000 : 2'000'000;
  constexpr int kTimed = 200;
  const EdgeArithmetic arithmetic = series.arithmetic;
  Configuration c;
  c.series = series.name;
  c.parameter = width;
  c.items = double(kTimed) * kEdgeTile * kEdgeTile;
  c.work = [arithmetic, triangles = timed_triangles(width, kTimed)](int) {
    consume(count_covered(arithmetic, triangles));
  };
  c.scene = "wrong decisions";
  c.error = [=] { return rate(is_wrong, arithmetic, width, samples); };
  c.predicted_error = predict(series.wrong, width);
  all.push_back(c);
  c.scene = "gaps and doubles";
  c.error = [=] { return rate(is_leak, arithmetic, width, samples); };
  c.predicted_error = predict(series.leak, width);
  all.push_back(std::move(c));
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  for (const Series& series : kSeries) {
    for (const int width : {1920, 7680, 32768}) add_series(all, series, width, effort);
  }
  return all;
}

}  // namespace

Experiment d03_edge_arithmetic() {
  return {.id = "D-3",
          .name = "Coverage: in which arithmetic edges are evaluated",
          .question =
              "How often do rounded edge functions give a pixel to the wrong triangle, to both or "
              "to neither?",
          .axis = "width of the screen",
          .axis_unit = "px",
          .error = "share of pixel centres within half a pixel of an edge that are decided wrongly",
          .error_unit = "",
          .reference = "128-bit integers, vertices snapped to 1/256 px",
          .theory =
              "E|error of the edge function| / (longer side of the edge * 1 px), roundings counted "
              "as random, 0.42 u "
              "each: two equal products for the difference form (0.048 u W on average), one with "
              "FMA, three "
              "products and three sums of the size of the screen for the plane form. The plane "
              "form only changes its sign "
              "with the edge's direction, so that it is wrong but leaves no gap; integers, and "
              "doubles of 53 bits "
              "for values of 50, are exact",
          .item = "pixel",
          .configurations = configurations};
}

}  // namespace glassbox::study
