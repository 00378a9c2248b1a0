// One-dimensional filters. One filter along x followed by one along y makes a two-dimensional
// filter of a metric.
#pragma once

#include <array>
#include <cstddef>

#include <glassbox/compare/metrics/wide.h>

namespace glassbox {

// The weights at distance 1, 2, ..., radius from the centre; the weight of the centre follows from
// the sum of all weights.
template <class Real, std::size_t radius>
using Taps = std::array<Real, radius>;

// out[x] = the weighted sum of in[x - radius * step] ... in[x + radius * step], with the same
// weights on both sides; `sum` is the sum of all weights. It is computed as sum * centre + weights
// * (both sides - 2 centre), so the result for a constant picture is exact: unchanged for a sum of
// 1, 0 for a sum of 0. The distant, small weights are added first.
template <std::ptrdiff_t step, class Real, std::size_t radius>
GLASSBOX_INLINE void filter_even(const Real* in, int count, const Taps<Real, radius>& weights,
                                 Real sum, Real* __restrict out) {
  for (int x = 0; x < count; ++x) {
    const Real twice = in[x] + in[x];
    Real total = 0;
#pragma GCC unroll 16
    for (std::size_t r = radius; r > 0; --r) {
      const std::ptrdiff_t away = std::ptrdiff_t(r) * step;
      total += weights[r - 1] * ((in[x - away] + in[x + away]) - twice);
    }
    out[x] = sum * in[x] + total;
  }
}

// A filter whose weights have opposite signs before and after the centre and are 0 at it.
template <std::ptrdiff_t step, class Real, std::size_t radius>
GLASSBOX_INLINE void filter_odd(const Real* in, int count, const Taps<Real, radius>& weights,
                                Real* __restrict out) {
  for (int x = 0; x < count; ++x) {
    Real total = 0;
#pragma GCC unroll 16
    for (std::size_t r = radius; r > 0; --r) {
      const std::ptrdiff_t away = std::ptrdiff_t(r) * step;
      total += weights[r - 1] * (in[x + away] - in[x - away]);
    }
    out[x] = total;
  }
}

}  // namespace glassbox
