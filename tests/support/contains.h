// Whether a text contains another, for checks of messages.
#pragma once

#include <string>

namespace glassbox::test {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace glassbox::test
