// A lab whose folder is outside the source tree: its judge is compiled and loaded while the program
// runs.
#pragma once

#include <filesystem>
#include <string>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// The lab's folder, with links and dots resolved. It is an error if it is not a folder, has no name
// of the form NN-name, or lacks one of the files that a lab needs.
Result<std::filesystem::path> find_outside_lab(const std::string& folder);

// The lab of sources.outside: its checks.cpp and the judge's other sources there are compiled into
// `place`, loaded, and kept until the program ends. The result of an earlier compilation of the
// same files by the same compiler for the same program is used again; several programs may do this
// at the same time. The judge is the teacher's code and is not confined. An error contains the
// compiler's messages, the symbols that the linker did not find, or the check of a task that the
// lab does not have.
Result<const Lab*> load_outside_lab(const Sources& sources, const std::filesystem::path& place);

// A digest of all files that the judge of sources.outside is compiled from.
Result<std::string> judge_digest(const Sources& sources);

}  // namespace glassbox::labs::grading
