// What the program has asked operator new for: a measure of work and memory that no clock and no other program disturbs. Link
// allocations.cpp, which replaces the operator, into the test program.
#pragma once

#include <cstdint>

namespace glassbox::test {

struct Allocations {
  std::uint64_t calls = 0;
  std::uint64_t bytes = 0;
};

// Since the program began, in all threads.
Allocations allocations();

}  // namespace glassbox::test
