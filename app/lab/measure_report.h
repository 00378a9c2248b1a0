// What glassbox lab measure says of an experiment with a student's series in it.
#pragma once

#include <string>
#include <vector>

#include "labs/framework/lab.h"
#include "labs/measuring/measuring.h"
#include "study/experiment/results.h"

namespace glassbox::app {

// A table of the student's points, each with what the experiment's own ways at that place leave of it.
std::string measure_text(const labs::Lab& lab, const labs::LabMeasure& measured,
                         const study::ExperimentResult& result,
                         const std::vector<std::string>& series);

}  // namespace glassbox::app
