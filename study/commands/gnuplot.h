// Commands by which gnuplot draws a chart of the study.
#pragma once

#include <string>

#include "study/experiment/results.h"

namespace glassbox::study {

// The commands that draw the chart and write it to the file `svg`.
std::string time_chart_commands(const study::ExperimentResult& result, const std::string& svg);
std::string axis_chart_commands(const study::ExperimentResult& result, const std::string& svg);

}  // namespace glassbox::study
