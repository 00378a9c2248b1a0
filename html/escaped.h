// Text of any bytes in HTML, SVG or XML.
#pragma once

#include <string>

namespace glassbox {

// As text of an element, or of an attribute in double quotes, which "&", "<", ">" and the quotes do not end. What XML cannot
// hold becomes U+FFFD: bytes that are not UTF-8, U+FFFE, U+FFFF, and control characters but tab, line feed and carriage return.
std::string escaped(const std::string& text);

}  // namespace glassbox
