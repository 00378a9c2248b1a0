// Separation, window and largest parallax over the frames, as an SVG picture.
#pragma once

#include <string>

#include "app/frames/frames_report.h"

namespace glassbox::app {

// Draws a plot that is readable on a light background and a dark one, with a description in words
// (title, desc) for people who cannot see it. The report must have eyes and at least one frame.
std::string plot_svg(const FramesReport& report);

}  // namespace glassbox::app
