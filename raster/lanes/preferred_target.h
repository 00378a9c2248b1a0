// What best_target() says, told otherwise: for tests of what has no option for it.
#pragma once

#include <optional>

#include <glassbox/raster/lanes/target.h>

namespace glassbox {

// From now on best_target() is this one, which must be available; none: the best there is. Nothing
// may be drawn meanwhile.
void prefer_target(std::optional<Target> target);

}  // namespace glassbox
