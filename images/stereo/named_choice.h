// Choices that a user makes by their name.
#pragma once

#include <string_view>

namespace glassbox {

// A value with its name for the command line and a description in one line.
template <class Value>
struct NamedChoice {
  Value value;
  std::string_view name;
  std::string_view description;
};

}  // namespace glassbox
