// The report of `glassbox lab measure` on an experiment that includes a student's series.
#pragma once

#include <string>
#include <vector>

#include "labs/framework/lab.h"
#include "labs/measuring/measuring.h"
#include "study/experiment/results.h"

namespace glassbox::labs {

// A table of the student's points, each with its standing among the experiment's own
// configurations. `untouched` are the series whose functions the student has not written.
std::string measure_text(const labs::Lab& lab, const labs::LabMeasure& measured,
                         const study::ExperimentResult& result,
                         const std::vector<std::string>& series,
                         const std::vector<std::string>& untouched);

// The text that replaces the table if there is no point at all.
std::string unwritten_text(const labs::Lab& lab, const labs::LabMeasure& measured);

}  // namespace glassbox::labs
