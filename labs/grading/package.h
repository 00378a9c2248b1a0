// Archives from which glassbox is built elsewhere: by an autograder, and by students.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/zip.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// The sources of the program in the clone `tree`, each with its path below `prefix` ("glassbox/"),
// without tests and documents.
Result<std::vector<ZipEntry>> program_files(const std::filesystem::path& tree,
                                            const std::string& prefix);

// The sources and documents of the program in the clone `tree`, with the labs as students get them
// (framework/student_version.h). A program built from these files is a glassbox for students, with
// the commands that they need.
Result<std::vector<ZipEntry>> students_files(const std::filesystem::path& tree);

}  // namespace glassbox::labs::grading
