// A run of several experiments, which may be stopped and taken up again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"
#include "study/experiment/runner.h"

namespace glassbox::study {

// The results of `chosen`, in their order. With a file, what it has is not measured again, and what is measured goes into
// it, one experiment after the other; what it has besides stays there.
Result<StudyResults> run_study(const std::vector<const Experiment*>& chosen, const Origin& origin,
                               const RunOptions& options, const std::optional<std::string>& file);

}  // namespace glassbox::study
