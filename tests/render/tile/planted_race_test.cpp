// A race that ThreadSanitizer must report. Never run with the other tests.
#include <atomic>
#include <chrono>
#include <thread>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

// Each task waits for the other, so that one thread cannot run both, however busy the machine is.
// They wait by relaxed operations, which order nothing.
TEST_CASE("two tasks add to one number, unprotected", "[.planted-race]") {
  constexpr std::chrono::seconds kLongest(60);
  long sum = 0;
  std::atomic<int> begun = 0;
  tbb::task_arena arena(2);
  arena.execute([&] {
    tbb::parallel_for(
        0, 2,
        [&](int) {
          begun.fetch_add(1, std::memory_order_relaxed);
          const auto end = std::chrono::steady_clock::now() + kLongest;
          while (begun.load(std::memory_order_relaxed) < 2 &&
                 std::chrono::steady_clock::now() < end) {
            std::this_thread::yield();
          }
          sum += 1;
        },
        tbb::simple_partitioner());
  });
  CHECK(sum > 0);
}

}  // namespace
}  // namespace glassbox
