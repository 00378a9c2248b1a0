// Results of the study: for people, for spreadsheets, for papers, and as a page.
#pragma once

#include <string>

#include "cli/report/table.h"
#include "study/experiment/results.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

// One table for each experiment, followed by what the theory predicts and the findings.
std::string study_text(const study::StudyResults& results);

// The origin of the results in one line: machine, compiler, flags, version, effort.
std::string origin_text(const study::Origin& origin);

// A name with its unit, if there is one: "offset [m]", "w at the far end over w at the near end".
std::string with_unit(const std::string& name, const std::string& unit);

// The largest unit in which the shortest of the experiment's times has digits before the decimal
// point.
TimeUnit time_unit(const study::ExperimentResult& result);

// CSV: a line of column names, then a line for each configuration and number of threads
// (docs/study.md).
std::string study_csv(const study::StudyResults& results);

// The commands for gnuplot that draw the chart and write it to the file `svg`.
std::string time_chart_commands(const study::ExperimentResult& result, const std::string& svg);
std::string axis_chart_commands(const study::ExperimentResult& result, const std::string& svg);

// Charts as SVG files, for papers and slides. They are drawn by gnuplot.
Result<void> check_gnuplot();  // an error if gnuplot is not installed

// Writes DIRECTORY/D-4-time.svg and D-4-axis.svg for each experiment, and D-4-2-time.svg and so on
// for its further measures. Returns the number of files.
Result<int> write_svg_charts(const study::StudyResults& results, const std::string& directory);

// A page that needs no other file and no network: charts, tables and findings. It shows the command
// that measures each experiment, and at its end the command that made the page.
std::string study_page(const study::StudyResults& results, const std::string& command);

// "0.1.0, build 3f2a9c01": the version, and a checksum of the program file, which differs between
// builds.
std::string version_and_build();

}  // namespace glassbox::study
