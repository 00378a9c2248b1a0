// Splits an experiment with several measures into one result for each measure.
#pragma once

#include <vector>

#include "study/experiment/results.h"

namespace glassbox::study {

// Returns the experiment with its own error first, then one result for each of its measures. Each
// result has the error and the axis of its measure, only the configurations of that measure, and no
// measures of its own. Measures without configurations are left out.
std::vector<ExperimentResult> by_measure(const ExperimentResult& experiment);

}  // namespace glassbox::study
