// A lab whose folder lies outside of the source tree: its judge is compiled while the program runs, and loaded.
#pragma once

#include <filesystem>
#include <string>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// The lab's folder, with links and dots resolved. An error names what is no folder, has no name NN-name, or misses one of the
// files that a lab is made of.
Result<std::filesystem::path> find_outside_lab(const std::string& folder);

// The lab of sources.outside: its checks.cpp, and what other sources lie there for the judge, compiled into `place`, loaded, and
// kept until the program ends. What was compiled of the same files by the same compiler for the same program is found again
// there; several programs may look for it at the same time. The judge is the teacher's code: nothing confines it. An error has
// the compiler's words, what the linker did not find, or a check of a task that the lab does not have.
Result<const Lab*> load_outside_lab(const Sources& sources, const std::filesystem::path& place);

// Of all files that the judge of sources.outside is compiled from.
Result<std::string> judge_digest(const Sources& sources);

}  // namespace glassbox::labs::grading
