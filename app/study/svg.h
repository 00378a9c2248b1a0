// Charts of the study as SVG files, for papers and slides. gnuplot draws them.
#pragma once

#include <string>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"

namespace glassbox::app {

// An error where there is no gnuplot.
Result<void> check_gnuplot();

// DIRECTORY/D-4-time.svg and D-4-axis.svg of each experiment, D-4-2-time.svg and so on of its further measures; how many were written.
Result<int> write_svg_charts(const study::StudyResults& results, const std::string& directory);

}  // namespace glassbox::app
