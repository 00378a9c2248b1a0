// What `glassbox bench` has measured.
#pragma once

#include <string>
#include <vector>

#include "study/bench/measure.h"
#include "study/bench/scaling.h"

namespace glassbox::app {

struct BenchReport {
  std::string machine, compiler, engine, target;
  int width = 0, height = 0, frames = 0;
  std::vector<study::Measurement> results;
  std::vector<study::Scaling> scalings;
  std::vector<std::string> notes;  // a sentence each

  // Whether every picture that was compared is the same.
  bool pictures_same() const;
};

}  // namespace glassbox::app
