// A number for every pixel and disparity: how unlike the two pixels are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

#include <glassbox/base/line_memory.h>

namespace glassbox::views {

// The greatest cost. Sixteen paths of cost and penalty fit 16 bits: 16 (kHighestCost + kHighestPenalty) < 2^16.
inline constexpr std::uint16_t kHighestCost = 2047;
inline constexpr std::uint16_t kHighestPenalty = 2047;
// Of the disparities that only fill up the lanes: above every sum of cost and penalty, so that they win nothing.
inline constexpr std::uint16_t kNeverCost = 8188;
inline constexpr int kDisparityLanes = 32;  // 16-bit lanes of the widest instruction set

// Memory of this size is not written before it is used: pages of it that nobody has touched cost nothing yet.
template <class T>
struct UnwrittenAllocator : LineAllocator<T> {
  UnwrittenAllocator() = default;
  template <class U>
  UnwrittenAllocator(const UnwrittenAllocator<U>&) {}
  template <class U>
  struct rebind {
    using other = UnwrittenAllocator<U>;
  };
  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Values>
  void construct(U* place, Values&&... values) {
    ::new (static_cast<void*>(place)) U(std::forward<Values>(values)...);
  }
};

struct CostVolume {
  int width = 0, height = 0;  // px
  int first = 0;              // disparity of number 0
  int count = 0;              // disparities
  int stride = 0;             // count, filled up to whole lanes
  std::vector<std::uint16_t, UnwrittenAllocator<std::uint16_t>> costs;

  CostVolume() = default;
  CostVolume(int width_, int height_, int first_, int count_)
      : width(width_),
        height(height_),
        first(first_),
        count(count_),
        stride((count_ + kDisparityLanes - 1) / kDisparityLanes * kDisparityLanes),
        costs(std::size_t(width_) * std::size_t(height_) * std::size_t(stride)) {}

  // Of the disparities of one pixel, one after the other.
  std::uint16_t* at(int x, int y) {
    return costs.data() +
           (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(stride);
  }
  const std::uint16_t* at(int x, int y) const { return const_cast<CostVolume*>(this)->at(x, y); }
  // Numbers of the disparities whose right pixel is in the picture: from .. to - 1; none where from >= to.
  int from(int x) const { return std::max(0, x - (width - 1) - first); }
  int to(int x) const { return std::min(count, x - first + 1); }
};

}  // namespace glassbox::views
