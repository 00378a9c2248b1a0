// The files that Gradescope builds an autograder from:
// https://gradescope-autograders.readthedocs.io/en/latest/specs/.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/lab.h"
#include "labs/framework/zip.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// The files: setup.sh, which builds glassbox once in the autograder's image; run_autograder, which
// grades one submission; and under glassbox/ the sources of the program, from `tree`, a clone of
// glassbox.
//
// The layout is Gradescope's, /autograder/{source,submission,results}. The environment variable
// GLASSBOX_AUTOGRADER names another folder in place of /autograder, to try the archive without
// Gradescope.
Result<std::vector<ZipEntry>> autograder_files(const Lab& lab, const std::filesystem::path& tree,
                                               const std::vector<std::string>& options);

// The texts of the two scripts, setup.sh and run_autograder.
std::string setup_script();
std::string run_script(int lab, const std::vector<std::string>& options);

}  // namespace glassbox::labs::grading
