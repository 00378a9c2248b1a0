// The files that a student starts with.
#pragma once

#include <vector>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

// A folder that builds on its own: the handout and its pictures, the contract (student.h),
// student.cpp without its solutions, the visible cases and the runner, and settings for compiler
// and debugger. An error if a line of a solution were left.
Result<std::vector<labs::SourceFile>> make_starter(const labs::Sources& sources,
                                                   const labs::Lab& lab);

}  // namespace glassbox::labs
