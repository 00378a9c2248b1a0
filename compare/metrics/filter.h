// One-dimensional filters. One of them along x and one along y make the two-dimensional filters of the metrics.
#pragma once

#include <array>
#include <cstddef>

namespace glassbox {

// The weights at distance 1, 2, ..., radius from the centre; the centre's own follows from the sum of all.
template <class Real, std::size_t radius>
using Taps = std::array<Real, radius>;

// out[x] = the weighted sum of in[x - radius * step] ... in[x + radius * step], the weights the same on both sides and
// `sum` all together. Written as sum * centre + weights * (both sides - 2 centre), a constant picture comes out
// exactly: as it is for a sum of 1, as 0 for a sum of 0. The far and small weights are added first.
template <std::ptrdiff_t step, class Real, std::size_t radius>
inline void filter_even(const Real* in, int count, const Taps<Real, radius>& weights, Real sum,
                        Real* out) {
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

// A filter whose weights have the opposite sign before the centre and are 0 at it.
template <std::ptrdiff_t step, class Real, std::size_t radius>
inline void filter_odd(const Real* in, int count, const Taps<Real, radius>& weights, Real* out) {
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
