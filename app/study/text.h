// Results of the study for people.
#pragma once

#include <string>

#include "app/report/table.h"

#include "study/experiment/results.h"

namespace glassbox::app {

// One table for each experiment, with what the theory says and the findings below it.
std::string study_text(const study::StudyResults& results);

// The origin in one line: machine, compiler, flags, version, effort.
std::string origin_text(const study::Origin& origin);

// "w at the far end over w at the near end", with the unit where there is one: "offset [m]".
std::string with_unit(const std::string& name, const std::string& unit);

// The one in which the shortest of the experiment's times has digits before the point.
TimeUnit time_unit(const study::ExperimentResult& result);

}  // namespace glassbox::app
