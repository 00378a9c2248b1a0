// Makes the input of a failure simpler while the answer stays wrong.
#pragma once

#include <filesystem>
#include <vector>

#include "labs/framework/judge_check.h"
#include "labs/framework/run_check.h"

namespace glassbox::labs {

// If the first failure of the check is in a class of generated inputs, replaces its input by the
// simplest one that is found with a failure of the same kind: a wrong answer, an exception or a
// crash. Runs the student's program at most about kMaxShrinkRuns times. A failure that cannot be
// repeated stays as it is.
inline constexpr int kMaxShrinkRuns = 300;
void shrink_failure(CheckResult& result, const std::vector<Case>& cases, Runner& runner,
                    const std::filesystem::path& program, const RunLimits& limits);

}  // namespace glassbox::labs
