// Memory that begins at the start of a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace glassbox {

inline constexpr std::size_t kCacheLine = 64;  // bytes; no vector register is longer

template <class T>
struct LineAllocator {
  using value_type = T;

  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}

  // Different versions of clang-format put different spaces around these operators.
  // clang-format off
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(bytes_of(count), std::align_val_t{kCacheLine}));
  }
  void deallocate(T* memory, std::size_t) {
    ::operator delete(memory, std::align_val_t{kCacheLine});
  }
  // clang-format on
  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }

private:
  static std::size_t bytes_of(std::size_t count) {
    if (count > std::size_t(-1) / sizeof(T)) throw std::bad_array_new_length();
    return count * sizeof(T);
  }
};

template <class T>
using LineVector = std::vector<T, LineAllocator<T>>;

}  // namespace glassbox
