// A whole lab, checked on one student's file: built, run, judged.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "labs/framework/build.h"
#include "labs/framework/judge.h"
#include "labs/framework/run_check.h"

namespace glassbox::labs {

struct CheckOptions {
  bool with_hidden = false;
  RunLimits limits;
};

// Builds in request.build_dir and puts each check to a process of its own, several at a time. A file that does not compile is a
// result without points; an error is what kept the lab from being checked at all.
Result<LabResult> check_lab(const Lab& lab, const Sources& sources, const BuildRequest& request,
                            const CheckOptions& options, Runner& runner);

}  // namespace glassbox::labs
