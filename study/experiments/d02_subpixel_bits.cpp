// Compares numbers of subpixel bits, that is, grids of different fineness to which vertices are
// rounded before coverage is decided (D-2).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>

#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/memoize.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace d02 {

constexpr int kSide = 256;      // px; side of the square that contains all triangles
constexpr int kExactBits = 20;  // vertices are multiples of 2^-20 px: 28 bits, edge functions: 61
using Corner = std::array<std::int64_t, 2>;
using Triangle = std::array<Corner, 3>;

// ---- the scenes ----

std::int64_t exactly(double pixels) {
  return std::int64_t(std::floor(std::clamp(pixels, 0.0, kSide - 1.0) * 0x1p20));
}

// A triangle with three random corners in a box of 64 px.
Triangle random_triangle(Random& random) {
  const double x = random.between(0, kSide - 64), y = random.between(0, kSide - 64);
  Triangle t;
  for (Corner& corner : t)
    corner = {exactly(x + random.between(0, 64)), exactly(y + random.between(0, 64))};
  return t;
}

// A triangle that is 20 to 60 px long and half a pixel wide at one end, with width zero at the
// other.
Triangle thin_triangle(Random& random) {
  const double x = random.between(64, kSide - 64), y = random.between(64, kSide - 64);
  const double length = random.between(20, 60);
  const SinCos along = sin_cos(random.between(0, 2 * kPi));
  return {{{exactly(x), exactly(y)},
           {exactly(x - 0.5 * along.sin), exactly(y + 0.5 * along.cos)},
           {exactly(x + length * along.cos), exactly(y + length * along.sin)}}};
}

using MakeTriangle = Triangle (*)(Random&);

std::vector<Triangle> make_triangles(MakeTriangle make, int count) {
  Random random(2);
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) triangles.push_back(make(random));
  return triangles;
}

double perimeter(const Triangle& t) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &p = t[k], &q = t[(k + 1) % 3];
    sum += std::sqrt(square(double(q[0] - p[0])) + square(double(q[1] - p[1])));
  }
  return sum * 0x1p-20;
}

// ---- coverage of a triangle on a grid of 2^-bits px, in integers just wide enough ----

// Rounds to the grid of 2^-bits px, halves up, like the pipeline's own snapping.
std::int64_t snapped(std::int64_t exact, int bits) {
  const int dropped = kExactBits - bits;
  return dropped == 0 ? exact : (exact + (std::int64_t(1) << (dropped - 1))) >> dropped;
}

// Coordinates count half grid steps, so that pixel centres are integers even without subpixel bits.
// The edge functions in a square of 2^8 px then have 2 (8 + bits + 1) + 1 bits: 32-bit integers
// hold them up to 6 subpixel bits.
template <class Int>
class CoverageTest {
public:
  CoverageTest(const Triangle& t, int bits) : pixel_(Int(1) << (bits + 1)) {
    std::array<std::array<Int, 2>, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 2; ++i) v[k][i] = Int(2 * snapped(t[k][i], bits));
    }
    const Int area =
        (v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[2][0] - v[0][0]) * (v[1][1] - v[0][1]);
    empty_ = area == 0;
    if (area < 0) std::swap(v[1], v[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &from = v[(k + 1) % 3], &to = v[(k + 2) % 3];
      const Int a = from[1] - to[1], b = to[0] - from[0];
      const bool owns_zero = a > 0 || (a == 0 && b > 0);
      // The edge function at the centre of pixel (0, 0). If points on the edge belong to the
      // neighbouring triangle, it is reduced by one, so that a value of 0 or more always means
      // inside.
      const Int start = a * (pixel_ / 2 - from[0]) + b * (pixel_ / 2 - from[1]);
      start_[k] = owns_zero ? start : start - 1;
      step_x_[k] = a * pixel_, step_y_[k] = b * pixel_;
    }
  }

  bool at(int x, int y) const {
    if (empty_) return false;
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k)
      inside = inside && start_[k] + Int(x) * step_x_[k] + Int(y) * step_y_[k] >= 0;
    return inside;
  }

  // Counts the covered pixels of a row, with one addition per edge and pixel.
  int count(int x0, int x1, int y) const {
    if (empty_) return 0;
    std::array<Int, 3> e;
    for (std::size_t k = 0; k < 3; ++k)
      e[k] = start_[k] + Int(x0) * step_x_[k] + Int(y) * step_y_[k];
    int covered = 0;
    for (int x = x0; x < x1; ++x) {
      covered += (e[0] | e[1] | e[2]) >= 0;
      for (std::size_t k = 0; k < 3; ++k) e[k] += step_x_[k];
    }
    return covered;
  }

private:
  Int pixel_;
  bool empty_ = false;
  std::array<Int, 3> start_{}, step_x_{}, step_y_{};
};

struct Box {
  int x0, y0, x1, y1;
};
// The pixels that the triangle may cover before or after snapping, which moves no corner by more
// than half a pixel.
Box box_of(const Triangle& t) {
  const auto low = [&](std::size_t i) {
    return int(std::min({t[0][i], t[1][i], t[2][i]}) >> kExactBits) - 1;
  };
  const auto high = [&](std::size_t i) {
    return int(std::max({t[0][i], t[1][i], t[2][i]}) >> kExactBits) + 2;
  };
  return {low(0), low(1), high(0), high(1)};
}

// ---- error and work ----

// The names of the measures.
constexpr const char* kOverlap = "overlap";
constexpr const char* kCrawl = "crawl";

struct Changes {
  double flips = 0;  // pixels whose coverage changes by snapping, per pixel of boundary length
  double lost = 0;   // 1 - IoU: the fraction of the union of both coverages that is not in both
};

Changes changes_of(const std::vector<Triangle>& triangles, int bits) {
  std::int64_t changed = 0, united = 0;
  double boundary = 0;
  for (const Triangle& t : triangles) {
    const CoverageTest<std::int64_t> exact(t, kExactBits), on_grid(t, bits);
    const Box box = box_of(t);
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) {
        const bool before = exact.at(x, y), after = on_grid.at(x, y);
        changed += before != after;
        united += before || after;
      }
    }
    boundary += perimeter(t);
  }
  return {double(changed) / boundary, double(changed) / double(united)};
}

// Twice the triangle's area, in px^2.
double twice_area(const Triangle& t) {
  const auto side = [&](std::size_t k, std::size_t i) {
    return double(t[k][i] - t[0][i]) * 0x1p-20;
  };
  return std::abs(side(1, 0) * side(2, 1) - side(2, 0) * side(1, 1));
}

constexpr int kFrames = 64;

// Moves each triangle slowly by 8 px and measures how far the midpoint of an edge is beside its
// path, because the ends of the edge are snapped. The mean over the frames is subtracted, because a
// constant error is not visible as movement. Returns the root mean square in px.
double crawl(const std::vector<Triangle>& triangles, int bits) {
  Random random(3);
  const double step = std::ldexp(1.0, -bits), exact_step = std::ldexp(1.0, -kExactBits);
  double squares = 0;
  std::int64_t count = 0;
  for (const Triangle& t : triangles) {
    const SinCos direction = sin_cos(random.between(0, 2 * kPi));
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &p = t[k], &q = t[(k + 1) % 3];
      const double dx = double(q[0] - p[0]), dy = double(q[1] - p[1]);
      const double length = std::sqrt(square(dx) + square(dy));
      if (length == 0) continue;
      std::array<double, kFrames> off{};
      double mean = 0;
      for (std::size_t frame = 0; frame < kFrames; ++frame) {
        const double along = double(frame) * 8 / kFrames;
        const std::array<std::int64_t, 2> moved{std::int64_t(along * direction.cos * 0x1p20),
                                                std::int64_t(along * direction.sin * 0x1p20)};
        const auto displaced = [&](const Corner& corner, std::size_t i) {
          const std::int64_t exact = corner[i] + moved[i];
          return double(snapped(exact, bits)) * step - double(exact) * exact_step;
        };
        const double x = displaced(p, 0) + displaced(q, 0), y = displaced(p, 1) + displaced(q, 1);
        off[frame] = (y * dx - x * dy) / length / 2;
        mean += off[frame] / kFrames;
      }
      for (const double each : off) squares += square(each - mean);
      count += kFrames;
    }
  }
  return std::sqrt(squares / double(count));
}

template <class Int>
int cover_all(const std::vector<Triangle>& triangles, int bits) {
  int covered = 0;
  for (const Triangle& t : triangles) {
    const CoverageTest<Int> on_grid(t, bits);
    const Box box = box_of(t);
    for (int y = box.y0; y < box.y1; ++y) covered += on_grid.count(box.x0, box.x1, y);
  }
  return covered;
}

// The expected number of changed pixels per pixel of boundary. Snapping moves each end of an edge
// by up to half a step along x and along y, with a uniform distribution, so its sideways standard
// deviation is 2^-bits/sqrt(12) for every direction of the edge. The point at the fraction t of the
// edge moves by the mean of both ends with the weights 1 - t and t, which gives the factor
// sqrt((1-t)^2 + t^2); its mean over the edge is 1/2 + asinh(1)/(2 sqrt 2) = 0.8116. The pixels in
// the area that the edge sweeps change.
double predict(int bits) {
  return kMeanOfNormal * rms_of_step(std::ldexp(1.0, -bits)) * 0.8116;
}

// predict() gives the changed pixels per pixel of boundary. Half of them are added by snapping, so
// the union of both coverages is larger than the triangle by this half.
double predict_lost(int bits, const std::vector<Triangle>& triangles) {
  double boundary = 0, area = 0;
  for (const Triangle& t : triangles) boundary += perimeter(t), area += twice_area(t) / 2;
  const double changed = predict(bits) * boundary;
  return changed / (area + changed / 2);
}

// The two ends of an edge have independent sideways errors of 2^-bits/sqrt(12); its midpoint has
// half of their sum.
double predict_crawl(int bits) {
  return rms_of_step(std::ldexp(1.0, -bits)) / std::sqrt(2.0);
}

void add_scene(std::vector<Configuration>& all, const std::string& scene, MakeTriangle make,
               Effort effort) {
  const int count = effort == Effort::kFull ? 160000 : 16000;
  constexpr int kTimed = 500;
  const auto triangles = memoize([=] { return make_triangles(make, count); });
  for (const int bits : {0, 1, 2, 4, 6, 8, 10, 12}) {
    const auto changes = memoize([=] { return changes_of(triangles(), bits); });
    const std::string series = bits <= 6 ? "32-bit edges" : "64-bit edges";
    all.push_back({.series = series,
                   .parameter = double(bits),
                   .scene = scene,
                   .error = [=] { return changes().flips; },
                   .predicted_error = predict(bits),
                   .work =
                       [triangles = make_triangles(make, kTimed), bits](int) {
                         do_not_optimize(bits <= 6 ? cover_all<std::int32_t>(triangles, bits)
                                                   : cover_all<std::int64_t>(triangles, bits));
                       },
                   .items = kTimed});
    all.push_back({.series = series,
                   .parameter = double(bits),
                   .scene = scene,
                   .measure = kOverlap,
                   .error = [=] { return changes().lost; },
                   .predicted_error = predict_lost(bits, triangles())});
    all.push_back({.series = series,
                   .parameter = double(bits),
                   .scene = scene,
                   .measure = kCrawl,
                   .error =
                       [=] {
                         const auto first = triangles().begin();
                         return crawl({first, first + count / 16}, bits);
                       },
                   .predicted_error = predict_crawl(bits)});
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_scene(all, "triangles of up to 64 px", random_triangle, effort);
  add_scene(all, "twigs half a pixel wide", thin_triangle, effort);
  return all;
}

}  // namespace d02

Experiment d02_subpixel_bits() {
  using namespace d02;
  return {
      .id = "D-2",
      .name = "Snapping: how many subpixel bits",
      .question =
          "How many pixels belong to another triangle because vertices are rounded to a grid, and "
          "what does a finer grid cost?",
      .axis = "subpixel bits",
      .logarithmic_axis = false,
      .error = "pixels whose coverage changes, per pixel of boundary length",
      .error_unit = "pixels per px",
      .reference = "the coverage of the triangle before the snap, in exact integers",
      .theory =
          "the area that an edge sweeps when its ends move, with b subpixel bits: sqrt(2/pi) "
          "2^-b/sqrt(12) * 0.812 = 0.187 * 2^-b per pixel of its length. As a fraction of the "
          "union of both coverages, it follows from boundary and area. The middle of a gliding "
          "edge is off by half the sum of the errors of its ends, 2^-b/sqrt(12) sideways each: "
          "2^-b/sqrt(24)",
      .item = "triangle",
      .axis_is_chosen = true,
      .measures = {{kOverlap,
                    "1 - IoU: pixels in only one of the two coverages, divided by those in either",
                    ""},
                   {kCrawl,
                    "RMS distance of an edge's middle from its path while the triangle "
                    "glides by 8 px in 64 frames",
                    "px"}},
      .configurations = configurations};
}

}  // namespace glassbox::study
