#include "study/experiments/experiments.h"

namespace glassbox::study {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
#define ENTRY(name) name(),
#include <experiments.inc>
#undef ENTRY
  };
  return all;
}

}  // namespace glassbox::study
