// The formulas of rasterisation, for one number at a time (not vectors).
#pragma once

#include <array>
#include <cstddef>

#include <glassbox/base/numbers.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

#include <glassbox/raster/formulas/depth.h>
#include <glassbox/raster/formulas/edges.h>
#include <glassbox/raster/formulas/interpolate.h>
#include <glassbox/raster/formulas/snap.h>

}  // namespace glassbox
