#include <glassbox/base/large_pages.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace glassbox {

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20;

}  // namespace

void ask_for_large_pages(const void* memory, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  if (bytes < 2 * kLargePage) return;  // less might hold no whole one
  const auto page = std::uintptr_t(::sysconf(_SC_PAGESIZE));
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
  // A wish: there is nothing to do where it is not granted.
  (void)::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#else
  (void)memory, (void)bytes;
#endif
}

}  // namespace glassbox
