// Summarises a report of AddressSanitizer or UndefinedBehaviorSanitizer in one line.
#pragma once

#include <optional>
#include <string>

namespace glassbox::labs::grading {

// The first report in a program's output, as "heap-buffer-overflow, student.cpp:24, in
// is_back_face". Nothing if there is no report.
std::optional<std::string> sanitizer_finding(const std::string& printed);

}  // namespace glassbox::labs::grading
