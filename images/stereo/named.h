// Choices that a user makes by name.
#pragma once

#include <string_view>

namespace glassbox {

// A name for the command line, and what it stands for in one line.
template <class Value>
struct Named {
  Value value;
  std::string_view name;
  std::string_view description;
};

}  // namespace glassbox
