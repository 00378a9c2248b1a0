// The results measured by `glassbox bench`.
#pragma once

#include <string>
#include <vector>

#include "study/bench/floor.h"
#include "study/bench/measure.h"
#include "study/bench/scaling.h"

namespace glassbox::study {

struct BenchReport {
  std::string machine, compiler, engine, target;
  int width = 0, height = 0, frames = 0;
  std::vector<study::Measurement> results;
  std::vector<study::Floor> floors;  // one per number of threads, if they were asked for
  std::vector<study::Scaling> scalings;
  std::vector<std::string> notes;  // one sentence each

  // Whether all compared pictures are the same as the peer's.
  bool pictures_same() const;
  // The floor with the result's number of threads; null if there is none.
  const study::Floor* floor_of(const study::Measurement& result) const;
};

}  // namespace glassbox::study
