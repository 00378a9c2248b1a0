// The stages made again for another picture or triangle, from the words that a user types at the prompt.
#pragma once

#include <string>
#include <vector>

#include "app/step/stepper.h"

#include <glassbox/mesh/scene.h>

namespace glassbox::app {

// `more` has picture options, --triangle N, --pick X,Y and --vertex K; what it does not say stays as `choice` has it. A
// picked triangle stays the same when the picture changes afterwards.
Result<Staged> restage(const Scene& scene, bool bits, const StepChoice& choice,
                       const std::vector<std::string>& more);

OptionWords restage_options();

}  // namespace glassbox::app
