// Results of the study as a table for spreadsheets and scripts.
#pragma once

#include <string>

#include "study/experiment/results.h"

namespace glassbox::app {

// A line for each configuration and number of threads, after one with the names of the columns (docs/study.md).
std::string study_csv(const study::StudyResults& results);

}  // namespace glassbox::app
