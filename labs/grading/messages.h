// What a compiler says, so that a student reads the own line first.
#pragma once

#include <string>

namespace glassbox::labs::grading {

// Errors in a header or in the linker come from a line of student.cpp: where the first error is not in student.cpp, that line
// and its text stand before everything else; where a function is missing, its name. `source` is the text of student.cpp.
std::string own_line_first(const std::string& messages, const std::string& source);

}  // namespace glassbox::labs::grading
