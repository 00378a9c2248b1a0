// The study's results as a page that needs no other file and no network.
#pragma once

#include <string>

#include "study/experiment/results.h"

namespace glassbox::study {

// Charts, tables and findings, and for each experiment the command that measures it. `command`
// makes the page itself; it is shown at the end.
std::string study_page(const study::StudyResults& results, const std::string& command);

}  // namespace glassbox::study
