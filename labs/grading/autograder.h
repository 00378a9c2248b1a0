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
// Gradescope. With `vary` each submission has hidden inputs of its own (`lab grade --vary`), which
// follow from those who handed it in.
Result<std::vector<ZipEntry>> autograder_files(const Lab& lab, const std::filesystem::path& tree,
                                               const std::vector<std::string>& options,
                                               bool vary = false);

// The texts of the two scripts, setup.sh and run_autograder.
std::string setup_script();
std::string run_script(int lab, const std::vector<std::string>& options, bool vary = false);

// Those who handed in, from submission_metadata.json, which Gradescope puts beside the submission:
// https://gradescope-autograders.readthedocs.io/en/latest/submission_metadata/. The text is the
// users' ids (emails where there are none), sorted and joined by "+", so a group has one name.
Result<std::string> read_submitters(const std::filesystem::path& file);

}  // namespace glassbox::labs::grading
