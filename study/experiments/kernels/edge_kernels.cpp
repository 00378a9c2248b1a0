#include "study/experiments/kernels/edge_kernels.h"

#include <algorithm>

// Must be before any header of Highway: it excludes ARM's vectors of unknown size (SVE), which
// cannot be stored in an array.
#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "study/experiments/kernels/edge_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::study::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kSteps = 256;  // subpixel steps per pixel
constexpr int kCentre = 128;

// Whether one of the three edge values is negative; one test of the integers' sign bits answers
// this.
template <class D, class E>
auto outside(D d, const E& e) {
  const auto zero = hn::Zero(d);
  if constexpr (hwy::IsFloat<hn::TFromD<D>>()) {
    return hn::Or(hn::Or(hn::Lt(e[0], zero), hn::Lt(e[1], zero)), hn::Lt(e[2], zero));
  } else {
    return hn::Lt(hn::Or(hn::Or(e[0], e[1]), e[2]), zero);
  }
}

// Counts the covered pixels of a tile. Calls row(y), which returns a function of x that gives the
// edge's values for the pixels x, x + 1, ... in the lanes of a vector; a value of at least 0 is
// inside.
template <class D, class Row>
std::int64_t count(D d, const Row& row) {
  std::int64_t covered = 0;
  const int lanes = int(hn::Lanes(d));
  for (int y = 0; y < kEdgeTile; ++y) {
    auto at = row(y);
    for (int x = 0; x < kEdgeTile; x += lanes) {
      const auto e = at(x);
      covered += lanes - std::int64_t(hn::CountTrue(d, outside(d, e)));
    }
  }
  return covered;
}

template <class V>
using Three = std::array<V, 3>;

template <bool kFma>
std::int64_t by_difference(const TileEdges& t) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const V lane = hn::Mul(hn::Iota(d, 0.0f), hn::Set(d, float(kSteps)));
  return count(d, [&](int y) HWY_ATTR {
    Three<V> down;
    for (std::size_t k = 0; k < 3; ++k)
      down[k] = hn::Set(d, float(t.dx[k]) * (float(y * kSteps + kCentre) - float(t.y0[k])));
    return [&t, d, lane, down](int x) HWY_ATTR {
      const V px = hn::Add(lane, hn::Set(d, float(x * kSteps + kCentre)));
      Three<V> e;
      for (std::size_t k = 0; k < 3; ++k) {
        const V right = hn::Sub(px, hn::Set(d, float(t.x0[k])));
        const V dy = hn::Set(d, float(t.dy[k]));
        e[k] = kFma ? hn::NegMulAdd(dy, right, down[k]) : hn::Sub(down[k], hn::Mul(dy, right));
      }
      return e;
    };
  });
}

template <class T>
std::int64_t by_plane(const TileEdges& t) {
  const hn::ScalableTag<T> d;
  using V = hn::Vec<decltype(d)>;
  const V lane = hn::Mul(hn::Iota(d, T(0)), hn::Set(d, T(kSteps)));
  Three<T> a, c;
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] = -T(t.dy[k]);
    const T x1 = T(t.x0[k] + t.dx[k]), y1 = T(t.y0[k] + t.dy[k]);
    c[k] = T(t.x0[k]) * y1 - x1 * T(t.y0[k]);
  }
  return count(d, [&](int y) HWY_ATTR {
    Three<V> down;
    for (std::size_t k = 0; k < 3; ++k) down[k] = hn::Set(d, T(t.dx[k]) * T(y * kSteps + kCentre));
    return [&a, &c, d, lane, down](int x) HWY_ATTR {
      const V px = hn::Add(lane, hn::Set(d, T(x * kSteps + kCentre)));
      Three<V> e;
      for (std::size_t k = 0; k < 3; ++k)
        e[k] = hn::Add(hn::Add(hn::Mul(hn::Set(d, a[k]), px), down[k]), hn::Set(d, c[k]));
      return e;
    };
  });
}

// Steps from pixel to pixel, which is exact with integers from any starting point. kShift = 8 drops
// the factor 256 that all steps have. Within the tile, E/256 (E: the edge function) changes by less
// than 2^30 (edges have at most 2^23 steps along x and y), so a larger value has the same sign in
// the whole tile and can be limited to 2^30.
template <class T, int kShift>
std::int64_t by_steps(const TileEdges& t) {
  const hn::ScalableTag<T> d;
  using V = hn::Vec<decltype(d)>;
  const int lanes = int(hn::Lanes(d));
  constexpr std::int64_t kFar = std::int64_t(1) << (sizeof(T) == 4 ? 30 : 62);
  Three<T> corner, step_x, step_y;
  Three<V> lane;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t a = -t.dy[k], b = t.dx[k];
    const std::int64_t exact = a * (kCentre - t.x0[k]) + b * (kCentre - t.y0[k]) - t.bias[k];
    corner[k] = T(std::clamp(exact >> kShift, -kFar, kFar));
    step_x[k] = T(a * (kSteps >> kShift));
    step_y[k] = T(b * (kSteps >> kShift));
    T offsets[HWY_MAX_BYTES / sizeof(T)];
    for (int i = 0; i < lanes; ++i) offsets[i] = T(i) * step_x[k];
    lane[k] = hn::LoadU(d, offsets);
  }
  return count(d, [&](int y) HWY_ATTR {
    Three<T> start;
    for (std::size_t k = 0; k < 3; ++k) start[k] = T(corner[k] + T(y) * step_y[k]);
    return [start, d, &lane, &step_x](int x) HWY_ATTR {
      Three<V> e;
      for (std::size_t k = 0; k < 3; ++k)
        e[k] = hn::Add(lane[k], hn::Set(d, T(start[k] + T(x) * step_x[k])));
      return e;
    };
  });
}

std::int64_t count_all(EdgeArithmetic arithmetic, std::span<const TileEdges> triangles) {
  std::int64_t covered = 0;
  const auto each = [&](auto one) HWY_ATTR {
    for (const TileEdges& t : triangles) covered += one(t);
  };
  switch (arithmetic) {
    case EdgeArithmetic::kFloatDifference:
      each(by_difference<false>);
      break;
    case EdgeArithmetic::kFloatPlane:
      each(by_plane<float>);
      break;
    case EdgeArithmetic::kFloatFma:
      each(by_difference<true>);
      break;
    case EdgeArithmetic::kDouble:
      each(by_plane<double>);
      break;
    case EdgeArithmetic::kInt32Tile:
      each(by_steps<std::int32_t, 8>);
      break;
    case EdgeArithmetic::kInt64:
      each(by_steps<std::int64_t, 0>);
      break;
  }
  return covered;
}

}  // namespace glassbox::study::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glassbox::study {

HWY_EXPORT(count_all);

std::int64_t count_covered(EdgeArithmetic arithmetic, std::span<const TileEdges> triangles) {
  return HWY_DYNAMIC_DISPATCH(count_all)(arithmetic, triangles);
}

}  // namespace glassbox::study
#endif
