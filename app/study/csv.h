// Results of the study as a table for spreadsheets and scripts.
#pragma once

#include <string>

#include "study/experiment/results.h"

namespace glassbox::app {

// A field as RFC 4180 asks for.
std::string csv_field(const std::string& text);

// A line for each configuration and number of threads, after one with the names of the columns (docs/study.md).
std::string study_csv(const study::StudyResults& results);

}  // namespace glassbox::app
