// A cost for every pixel of the left picture and every disparity: how different the left pixel is
// from the right pixel at that disparity.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

#include <glassbox/base/cache_aligned_vector.h>

namespace glassbox::views {

// The greatest cost, and the greatest penalty that a path adds to it. The sum of sixteen paths must
// fit into 16 bits: 16 (kHighestCost + kHighestPenalty) < 2^16.
inline constexpr std::uint16_t kHighestCost = 2047;
inline constexpr std::uint16_t kHighestPenalty = 2047;
// The cost in the entries that only pad a pixel's disparities to whole vectors: it is above every
// sum of a cost and a penalty, so that such an entry is never the least.
inline constexpr std::uint16_t kNeverCost = 8188;
inline constexpr int kDisparityLanes = 32;  // 16-bit lanes of the widest instruction set

// An allocator that does not initialise its memory: the operating system provides a page of it only
// when the page is first used.
template <class T>
struct UnwrittenAllocator : CacheLineAllocator<T> {
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
  int width = 0, height = 0;  // in px
  int first = 0;              // the first disparity, which has the number 0
  int count = 0;              // number of disparities
  int stride = 0;             // count, padded to whole vectors
  std::vector<std::uint16_t, UnwrittenAllocator<std::uint16_t>> costs;

  CostVolume() = default;
  CostVolume(int width_, int height_, int first_, int count_)
      : width(width_),
        height(height_),
        first(first_),
        count(count_),
        stride((count_ + kDisparityLanes - 1) / kDisparityLanes * kDisparityLanes),
        costs(std::size_t(width_) * std::size_t(height_) * std::size_t(stride)) {}

  // The costs of one pixel, by disparity.
  std::uint16_t* at(int x, int y) {
    return costs.data() +
           (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(stride);
  }
  const std::uint16_t* at(int x, int y) const { return const_cast<CostVolume*>(this)->at(x, y); }
  // Numbers of the disparities whose right pixel is inside the picture: from .. to - 1; none if
  // from >= to.
  int from(int x) const { return std::max(0, x - (width - 1) - first); }
  int to(int x) const { return std::min(count, x - first + 1); }
};

}  // namespace glassbox::views
