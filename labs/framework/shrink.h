// Makes the input of a failure simpler while the answer stays wrong.
#pragma once

#include <filesystem>
#include <vector>

#include "labs/framework/judge_check.h"
#include "labs/framework/run_check.h"

namespace glassbox::labs {

// At most about so many times the student's program is run to shrink one failure.
inline constexpr int kMaxShrinkRuns = 300;

// If the first failure of the check is in a class of generated inputs, replaces its input by the
// simplest one that is found with a failure of the same kind: a wrong answer, an exception or a
// crash. A failure that cannot be repeated stays as it is. It also stays if a process does not
// start or reaches a limit, such as that of time: how far the search came by then depends on the
// machine's load, and the same submission must have the same report.
void shrink_failure(CheckResult& result, const std::vector<Case>& cases, Runner& runner,
                    const std::filesystem::path& program, const RunLimits& limits);

}  // namespace glassbox::labs
