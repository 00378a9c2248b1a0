// The report as text for the terminal.
#pragma once

#include <string>
#include <vector>

#include "app/stereo/advice.h"
#include "app/stereo/findings.h"
#include "app/stereo/verdicts.h"

namespace glassbox::app {

// The parallax at a distance, and the name of what is there.
struct ParallaxRow {
  std::string name;
  Parallax parallax;
  DisplayedParallax displayed;
};
// The rows from near to far: the planes, the window, and the visible depths.
std::vector<ParallaxRow> parallax_rows(const StereoFindings& found);

// The parts of a report that are sentences.
struct StereoWords {
  std::vector<Verdict> verdicts;
  std::vector<Advice> advice;
};

std::string stereo_text(const StereoFindings& found, const StereoWords& words);

}  // namespace glassbox::app
