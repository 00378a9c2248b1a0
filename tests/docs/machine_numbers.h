// Finds numbers whose last digits depend on the machine: C++ leaves them to the C library or the
// processor.
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

// Finds calls of std::exp and similar functions, which base/elementary.h and base/trig.h replace
// with the same result everywhere; `long double`, which has 64 or 113 bits; and Eigen's rotations
// by an angle, which call std::sin. It looks at the tokens of a C++ source alone. std::sqrt,
// std::floor and others that IEEE 754 defines do not count.
std::vector<MachineNumber> machine_numbers(std::string_view source);

}  // namespace glassbox::test
