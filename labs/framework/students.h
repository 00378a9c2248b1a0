// The labs as a glassbox for students has them: without solutions, hidden checks and planted faults.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <glassbox/base/error.h>

namespace glassbox::labs {

// Whether a path from the top of a clone leads into a lab's folder, labs/NN-name/.
bool is_of_a_lab(const std::filesystem::path& path);

// What becomes of the file `name` of a lab's folder: solutions give way to their stubs, hidden parts go (strip.h), and of a call
// hidden_check(...) of the judge nothing stays but that its task has one: hidden_elsewhere("5.1"). None for a file that students
// do not get. Its own output comes out as it is.
Result<std::optional<std::string>> for_students(const std::string& name, const std::string& text);

// The folder labs/ of a clone, written to `to` in that way: the labs, the framework and what runners are made of.
Result<void> copy_for_students(const std::filesystem::path& labs, const std::filesystem::path& to);

}  // namespace glassbox::labs
