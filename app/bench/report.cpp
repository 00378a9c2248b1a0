#include "app/bench/report.h"

#include <algorithm>

namespace glassbox::app {

bool BenchReport::pictures_same() const {
  return std::ranges::all_of(results, [](const study::Measurement& result) {
    return !result.against || result.against->match.same();
  });
}

}  // namespace glassbox::app
