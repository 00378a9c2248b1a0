// For the sanitizer of threads: a race that it must report. Never run with the other tests.
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

TEST_CASE("two tasks add to one number, unprotected", "[.planted-race]") {
  long sum = 0;
  tbb::task_arena arena(4);
  arena.execute([&] {
    tbb::parallel_for(
        0, 100000, [&](int) { sum += 1; }, tbb::simple_partitioner());
  });
  CHECK(sum > 0);
}

}  // namespace
}  // namespace glassbox
