// The inspector page of a run that used a student's functions.
#pragma once

#include <string>
#include <vector>

#include "labs/commands/drawing_report.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

// Makes the page. `words` are the picture's options, as the user gave them. In lab 9 the run is the
// left eye's.
Result<std::string> lab_drawing_page(const DrawingReport& report, const labs::Drawn& drawn,
                                     const labs::DrawnBoth& both,
                                     const std::vector<std::string>& words);

}  // namespace glassbox::labs
