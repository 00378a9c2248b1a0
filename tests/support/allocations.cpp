#include "tests/support/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace glassbox::test {
namespace {

std::atomic<std::uint64_t> calls{0}, bytes{0};

void* counted(std::size_t size) noexcept {
  calls.fetch_add(1, std::memory_order_relaxed);
  bytes.fetch_add(size, std::memory_order_relaxed);
  return std::malloc(size == 0 ? 1 : size);
}

}  // namespace

Allocations allocations() {
  return {calls.load(std::memory_order_relaxed), bytes.load(std::memory_order_relaxed)};
}

}  // namespace glassbox::test

// The array forms of new and delete call these.
void* operator new(std::size_t size) {
  if (void* const memory = glassbox::test::counted(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return glassbox::test::counted(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
