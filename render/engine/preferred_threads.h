// Overrides default_threads(), for tests of functions that have no option for the number of
// threads.
#pragma once

#include <optional>

namespace glassbox {

// From now on default_threads() returns `threads`, which must be at least 1; with std::nullopt it
// returns the machine's number again. No picture may be drawn during the call.
void prefer_threads(std::optional<int> threads);

}  // namespace glassbox
