// Numbers whose last digits are those of a machine: C++ leaves them to the C library or the processor.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glassbox::test {

struct MachineNumber {
  std::size_t line = 0;  // counted from 1
  std::string name;
};

// Calls of std::exp and its like, which base/elementary.h and base/trig.h have the same everywhere, `long double`, which has 64 or 113
// bits, and rotations of Eigen's by an angle, which call std::sin. By the words of a C++ source alone; std::sqrt, std::floor and others
// that IEEE 754 defines are none.
std::vector<MachineNumber> machine_numbers(std::string_view source);

}  // namespace glassbox::test
