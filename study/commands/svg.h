// Charts of the study as SVG files for papers and slides, drawn by gnuplot.
#pragma once

#include <string>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"

namespace glassbox::study {

// An error if gnuplot is not installed.
Result<void> check_gnuplot();

// Writes DIRECTORY/D-4-time.svg and D-4-axis.svg for each experiment, and D-4-2-time.svg and so on
// for its further measures. Returns the number of files.
Result<int> write_svg_charts(const study::StudyResults& results, const std::string& directory);

}  // namespace glassbox::study
