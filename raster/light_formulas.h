// The formulas of light, for one number at a time (not vectors).
#pragma once

#include <array>
#include <cstddef>

#include <glassbox/base/numbers.h>
#include <glassbox/raster/shading.h>

namespace glassbox {

#include <glassbox/raster/formulas/lighting.h>

}  // namespace glassbox
