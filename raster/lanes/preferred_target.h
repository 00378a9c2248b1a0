// Overrides best_target(), for tests of functions that have no option for the instruction set.
#pragma once

#include <optional>

#include <glassbox/raster/lanes/target.h>

namespace glassbox {

// From now on best_target() returns `target`, which must be available; with std::nullopt it returns
// the best available target again. Nothing may be drawn during the call.
void prefer_target(std::optional<Target> target);

}  // namespace glassbox
