// Separation, window and largest parallax over the frames, as an SVG picture.
#pragma once

#include <string>

#include "app/frames/frames_report.h"

namespace glassbox::app {

// Readable on a light ground and a dark one, and told in words (title, desc) for those who do not see it. The report has
// eyes and at least one frame.
std::string plot_svg(const FramesReport& report);

}  // namespace glassbox::app
