// Memory in large pages, where the system has them.
#pragma once

#include <cstddef>
#include <vector>

namespace glassbox {

// Asks for large pages for memory that has not been written yet: a table of megabytes then takes a few entries of the processor's
// address cache instead of thousands. Where there are none, or the memory is small, nothing happens.
void ask_for_large_pages(const void* memory, std::size_t bytes);

// Grows to at least `size` entries, the new ones value-initialised or copies of `fill`.
template <class T>
void grow_in_large_pages(std::vector<T>& memory, std::size_t size, const T& fill = T()) {
  if (memory.size() >= size) return;
  memory.reserve(size);
  ask_for_large_pages(memory.data(), memory.capacity() * sizeof(T));
  memory.resize(size, fill);
}

}  // namespace glassbox
