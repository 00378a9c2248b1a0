// Finds names of structured bindings that lambdas capture: C++20 allows it, and clang++ 14 does not
// compile it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glassbox::test {

struct CapturedBinding {
  std::size_t line = 0;  // where the lambda uses the name, counted from 1
  std::string name;
};

// Finds the captured bindings of a C++ source by its tokens alone: `const auto& [a, b] = pair;` and
// then `[&] { return a; }`, but not `[&a = a] { return a; }`.
std::vector<CapturedBinding> captured_bindings(std::string_view source);

}  // namespace glassbox::test
