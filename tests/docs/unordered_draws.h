// Random numbers that are drawn in no order: C++ leaves open which argument of a call, or which side of a +, is computed first, and
// g++ and clang++ choose differently. Each argument of a call in braces, and each statement, is computed before the next.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace glassbox::test {

// The lines, counted from 1, of calls and expressions of a C++ source in which more than one is drawn, by its words alone: by a
// method of what is named "random", by a function that is given it, or by a lambda that does either.
std::vector<std::size_t> unordered_draws(std::string_view source);

}  // namespace glassbox::test
