// The report in the terminal.
#pragma once

#include <string>
#include <vector>

#include "app/stereo/advice.h"
#include "app/stereo/findings.h"
#include "app/stereo/verdicts.h"

namespace glassbox::app {

// A distance and what is there.
struct ParallaxRow {
  std::string name;
  Parallax parallax;
  DisplayedParallax displayed;
};
// From near to far: planes, window, and what is seen.
std::vector<ParallaxRow> parallax_rows(const StereoFindings& found);

// What a report says in words.
struct StereoWords {
  std::vector<Verdict> verdicts;
  std::vector<Advice> advice;
};

std::string stereo_text(const StereoFindings& found, const StereoWords& words);

}  // namespace glassbox::app
