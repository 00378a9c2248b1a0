// Escapes text with any bytes for HTML, SVG or XML.
#pragma once

#include <string>

namespace glassbox {

// The text as contents of an element, or of an attribute in double quotes: "&", "<", ">" and quotes
// are escaped. Bytes and characters that XML cannot hold become U+FFFD: bytes that are not UTF-8,
// U+FFFE, U+FFFF, and control characters except tab, line feed and carriage return.
std::string escaped_html(const std::string& text);

}  // namespace glassbox
