// Runs several experiments; the run can be stopped and continued.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"
#include "study/experiment/runner.h"

namespace glassbox::study {

// Returns the results of `chosen`, in their order. With a file, results that it already has are not
// measured again, and new ones are written to it after each experiment; other results in the file
// stay there.
Result<StudyResults> run_study(const std::vector<const Experiment*>& chosen, const Origin& origin,
                               const RunOptions& options, const std::optional<std::string>& file);

}  // namespace glassbox::study
