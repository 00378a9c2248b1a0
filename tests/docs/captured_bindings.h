// Names of structured bindings that lambdas capture, as C++20 allows and clang++ 14 does not compile.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glassbox::test {

struct CapturedBinding {
  std::size_t line = 0;  // of the lambda's use of the name, counted from 1
  std::string name;
};

// Of a C++ source, by its words alone: `const auto& [a, b] = pair;` and then `[&] { return a; }`, not `[&a = a] { return a; }`.
std::vector<CapturedBinding> captured_bindings(std::string_view source);

}  // namespace glassbox::test
