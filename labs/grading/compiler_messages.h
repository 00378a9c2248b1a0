// Reorders a compiler's messages so that a student reads the line of their own file first.
#pragma once

#include <string>

namespace glassbox::labs::grading {

// Errors in a header or in the linker are caused by a line of student.cpp. Where the first error is
// not in student.cpp, that line and its text are put before everything else; where a function is
// missing, its name. `source` is the text of student.cpp.
std::string student_line_first(const std::string& messages, const std::string& source);

}  // namespace glassbox::labs::grading
