// Suggests changes to a pair of eyes, in words and as options.
#pragma once

#include <string>
#include <vector>

#include "app/stereo/findings.h"

namespace glassbox::app {

struct Advice {
  std::string text;
  std::vector<std::string> options;  // options that replace the current ones; may be empty
};

// The suggestions; none if all is well. Separations and windows are computed by comfort.h for the
// visible depths. They have three digits and are rounded such that the budget is kept.
std::vector<Advice> advise(const Scene& scene, const StereoFindings& found);

}  // namespace glassbox::app
