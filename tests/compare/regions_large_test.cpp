// Regions of large pictures: the memory needed must be proportional to the length of a row.
#include "tests/support/catch.h"

#include <sys/resource.h>

#include <vector>

#include <glassbox/compare/pixels/regions.h>

namespace glassbox::test {
namespace {

constexpr int kSide = 4096;  // px

long peak_kilobytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// Computes each row with a function, so that no picture is in memory.
template <class IsSet>
std::vector<Region> regions_of(IsSet is_set, std::uint64_t& count) {
  RegionFinder finder(kSide, 100);
  std::vector<std::uint32_t> row(kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) row[std::size_t(x)] = is_set(x, y) ? 7 : 0;
    finder.add_row(y, row);
  }
  auto regions = finder.worst();
  count = finder.count();
  return regions;
}

// A row has at most 2048 runs with their regions, which need far less than a megabyte. The steps of
// all pixels would need 64 MiB.
void check_peak(long before) {
#if defined(__SANITIZE_ADDRESS__)
  (void)before;  // the address sanitizer keeps freed memory for a while
#else
  constexpr long kAllowed = 8 * 1024;  // KiB
  CHECK(peak_kilobytes() - before < kAllowed);
#endif
}

TEST_CASE("a checkerboard of 4096 x 4096 is one region of half of its pixels") {
  const long before = peak_kilobytes();
  std::uint64_t count = 0;
  const auto regions = regions_of([](int x, int y) { return (x + y) % 2 == 0; }, count);
  REQUIRE(count == 1);
  REQUIRE(regions.size() == 1);
  CHECK(regions[0].pixels == std::uint64_t(kSide) * kSide / 2);
  CHECK(regions[0].box == PixelBox{0, 0, kSide, kSide});
  check_peak(before);
}

TEST_CASE("four million single pixels are counted, and the first hundred kept") {
  const long before = peak_kilobytes();
  std::uint64_t count = 0;
  const auto regions = regions_of([](int x, int y) { return x % 2 == 0 && y % 2 == 0; }, count);
  CHECK(count == std::uint64_t(kSide) * kSide / 4);
  REQUIRE(regions.size() == 100);
  CHECK(regions[99].worst == PixelPosition{198, 0});
  check_peak(before);
}

TEST_CASE("two thousand teeth of a comb that meet in the last row are one region") {
  const long before = peak_kilobytes();
  std::uint64_t count = 0;
  const auto regions = regions_of([](int x, int y) { return x % 2 == 0 || y == kSide - 1; }, count);
  CHECK(count == 1);
  REQUIRE(regions.size() == 1);
  CHECK(regions[0].pixels == std::uint64_t(kSide) * kSide / 2 + kSide / 2);
  check_peak(before);
}

}  // namespace
}  // namespace glassbox::test
