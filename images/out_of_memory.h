// Turns a lack of memory into an error instead of an exception, for pictures that may be larger
// than the memory.
#pragma once

#include <new>
#include <stdexcept>

#include <glassbox/base/error.h>

namespace glassbox {

// Returns the Result of `make`, or an error if `make` runs out of memory.
template <class Make>
auto unless_out_of_memory(Make make, const char* cause = "needs more memory than there is",
                          const char* remedy = "close other programs, or make the picture smaller")
    -> decltype(make()) {
  const auto refused = [&] { return fail("", cause, remedy); };
  try {
    return make();
  } catch (const std::bad_alloc&) {
    return refused();
  } catch (const std::length_error&) {
    return refused();
  }
}

}  // namespace glassbox
