// What default_threads() says, told otherwise: for tests of what has no option for it.
#pragma once

#include <optional>

namespace glassbox {

// From now on default_threads() is this number, at least 1; none: as many as the machine has.
// Nothing may be drawn meanwhile.
void prefer_threads(std::optional<int> threads);

}  // namespace glassbox
