// Finds random numbers that are drawn in an unspecified order: C++ does not specify which argument
// of a call, or which side of a +, is computed first, and g++ and clang++ choose differently. The
// elements of an initializer in braces, and statements, are computed one after the other.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace glassbox::test {

// Returns the lines, counted from 1, of the calls and expressions of a C++ source in which more
// than one number is drawn. It looks at the tokens alone. A number is drawn by a method of an
// object named "random", by a function with that object as an argument, or by a lambda that does
// either.
std::vector<std::size_t> unordered_draws(std::string_view source);

}  // namespace glassbox::test
