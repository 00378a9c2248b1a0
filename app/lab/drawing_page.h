// The inspector on a run in which a student's functions took part.
#pragma once

#include <string>
#include <vector>

#include "app/lab/drawing_report.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// `words`: the picture's options, as the user gave them. Of lab 9 it is the left eye's run.
Result<std::string> lab_drawing_page(const DrawingReport& report, const labs::Drawn& drawn,
                                     const labs::DrawnBoth& both,
                                     const std::vector<std::string>& words);

}  // namespace glassbox::app
