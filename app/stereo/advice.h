// What to change about a pair, in words and as options.
#pragma once

#include <string>
#include <vector>

#include "app/stereo/findings.h"

namespace glassbox::app {

struct Advice {
  std::string text;
  std::vector<std::string> options;  // to be given in place of those there were; may be none
};

// None where all is well. Separations and windows come from comfort.h, for the depth that is seen; they have three
// digits and are rounded so that the budget is kept.
std::vector<Advice> advise(const Scene& scene, const StereoFindings& found);

}  // namespace glassbox::app
