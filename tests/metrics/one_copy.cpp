// Prints the metrics of generated pairs. Its functions of wide.h have no copy with AVX2.
#include <cstdio>

#include "tests/metrics/metric_bits.h"

int main() {
  std::fputs(glassbox::test::metric_bits().c_str(), stdout);
}
