// Counts what the program requests from operator new: a measure of work and memory that no clock
// and no other program disturbs. A test program that uses it must be linked with allocations.cpp,
// which replaces the operator.
#pragma once

#include <cstdint>

namespace glassbox::test {

struct Allocations {
  std::uint64_t calls = 0;
  std::uint64_t bytes = 0;
};

// Returns the counts of all threads since the program began.
Allocations allocations();

}  // namespace glassbox::test
