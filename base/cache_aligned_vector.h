// Memory that begins at the start of a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace glassbox {

inline constexpr std::size_t kCacheLine = 64;  // bytes; vector registers are not longer

template <class T>
struct CacheLineAllocator {
  using value_type = T;

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  // The next lines are not formatted, because different versions of clang-format put different
  // spaces around their operators.
  // clang-format off
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(bytes_of(count), std::align_val_t{kCacheLine}));
  }
  void deallocate(T* memory, std::size_t) {
    ::operator delete(memory, std::align_val_t{kCacheLine});
  }
  // clang-format on
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }

private:
  static std::size_t bytes_of(std::size_t count) {
    if (count > std::size_t(-1) / sizeof(T)) throw std::bad_array_new_length();
    return count * sizeof(T);
  }
};

template <class T>
using CacheAlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace glassbox
