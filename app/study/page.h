// The results of the study as a page that needs no other file and no network.
#pragma once

#include <string>

#include "study/experiment/results.h"

namespace glassbox::app {

// Charts, tables and findings; beside each experiment the command that measures it, at the end the page's own.
std::string study_page(const study::StudyResults& results, const std::string& command);

}  // namespace glassbox::app
