// Tests that the copies of functions for AVX2 (compare/metrics/wide.h) give the bits of the others.
#include "tests/metrics/metric_bits.h"
#include "tests/support/catch.h"
#include "tests/support/run_program.h"

namespace {

using namespace glassbox;

TEST_CASE("metrics have the same bits with the instructions of AVX2 and without", "[metrics]") {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) WARN("this processor has no AVX2: both programs do without");
#else
  WARN("both programs have one copy of each function, as this is no x86-64");
#endif
  const test::Outcome one_copy = test::run_program(GLASSBOX_METRICS_ONE_COPY, {}, ".");
  REQUIRE(one_copy.exit_code == 0);
  CHECK(one_copy.out == test::metric_bits());
}

}  // namespace
