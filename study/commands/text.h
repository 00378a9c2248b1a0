// The study's results as text.
#pragma once

#include <string>

#include "cli/report/table.h"

#include "study/experiment/results.h"

namespace glassbox::study {

// One table for each experiment, followed by what the theory predicts and the findings.
std::string study_text(const study::StudyResults& results);

// The origin of the results in one line: machine, compiler, flags, version, effort.
std::string origin_text(const study::Origin& origin);

// A name with its unit, if there is one: "offset [m]", "w at the far end over w at the near end".
std::string with_unit(const std::string& name, const std::string& unit);

// The unit in which the shortest of the experiment's times has digits before the decimal point.
TimeUnit time_unit(const study::ExperimentResult& result);

}  // namespace glassbox::study
