// What glassbox lab measure says of an experiment with a student's series in it.
#pragma once

#include <string>
#include <vector>

#include "labs/framework/lab.h"
#include "labs/measuring/measuring.h"
#include "study/experiment/results.h"

namespace glassbox::app {

// A table of the student's points, each with what the experiment's own ways at that place leave of it; `untouched` are those that
// nothing is written of.
std::string measure_text(const labs::Lab& lab, const labs::LabMeasure& measured,
                         const study::ExperimentResult& result,
                         const std::vector<std::string>& series,
                         const std::vector<std::string>& untouched);

// In place of it where there is no point.
std::string unwritten_text(const labs::Lab& lab, const labs::LabMeasure& measured);

}  // namespace glassbox::app
