// What `glassbox bench` has measured.
#pragma once

#include <string>
#include <vector>

#include "study/bench/floor.h"
#include "study/bench/measure.h"
#include "study/bench/scaling.h"

namespace glassbox::app {

struct BenchReport {
  std::string machine, compiler, engine, target;
  int width = 0, height = 0, frames = 0;
  std::vector<study::Measurement> results;
  std::vector<study::Floor> floors;  // by number of threads, where they were asked for
  std::vector<study::Scaling> scalings;
  std::vector<std::string> notes;  // a sentence each

  // Whether every picture that was compared is the same.
  bool pictures_same() const;
  // With the result's number of threads; null where there is none.
  const study::Floor* floor_of(const study::Measurement& result) const;
};

}  // namespace glassbox::app
