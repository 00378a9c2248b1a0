// The labs as students get them: without solutions, hidden checks and planted faults.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <glassbox/base/error.h>

namespace glassbox::labs {

// Whether a path relative to the top of a clone leads into a lab's folder, labs/NN-name/.
bool is_lab_path(const std::filesystem::path& path);

// The file `name` of a lab's folder as students get it: solutions are replaced by their stubs and
// hidden parts are removed (strip_solution.h). A call hidden_check(...) of the judge becomes
// hidden_check_placeholder("5.1"), which says only that task 5.1 has a hidden check. Empty for a
// file that students do not get. Applied to its own output it changes nothing.
Result<std::optional<std::string>> student_version(const std::string& name,
                                                   const std::string& text);

// Writes the folder labs/ of a clone to `to` as students get it: the labs, the framework and what
// runners (programs with a student's code) are made of.
Result<void> copy_for_students(const std::filesystem::path& labs, const std::filesystem::path& to);

}  // namespace glassbox::labs
