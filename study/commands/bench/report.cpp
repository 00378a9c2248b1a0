#include "study/commands/bench/report.h"

#include <algorithm>

namespace glassbox::study {

bool BenchReport::pictures_same() const {
  return std::ranges::all_of(results, [](const study::Measurement& result) {
    return !result.against || result.against->match.same();
  });
}

const study::Floor* BenchReport::floor_of(const study::Measurement& result) const {
  const auto found = std::ranges::find(floors, result.threads, &study::Floor::threads);
  return found == floors.end() ? nullptr : &*found;
}

}  // namespace glassbox::study
