// An experiment with several measures, taken apart.
#pragma once

#include <vector>

#include "study/experiment/results.h"

namespace glassbox::study {

// Its own error first, then each of its measures: each with that error and axis and without measures, and with the configurations
// that have it. Those that have none are left out.
std::vector<ExperimentResult> by_measure(const ExperimentResult& experiment);

}  // namespace glassbox::study
