// The study's results as a table for spreadsheets and scripts.
#pragma once

#include <string>

#include "study/experiment/results.h"

namespace glassbox::study {

// A line of column names, then a line for each configuration and number of threads (docs/study.md).
std::string study_csv(const study::StudyResults& results);

}  // namespace glassbox::study
