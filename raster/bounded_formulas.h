// The formulas of the stages, for numbers that carry a bound on their own error (base/bounded.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glassbox/base/bounded.h>
#include <glassbox/mesh/mesh.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/raster/shading.h>
#include <glassbox/raster/stages.h>
#include <glassbox/raster/texture.h>

namespace glassbox::bounded {

#include <glassbox/base/formulas/transform_row.h>
#include <glassbox/pipeline/formulas/vertex.h>
#include <glassbox/raster/formulas/blend.h>
#include <glassbox/raster/formulas/corners.h>
#include <glassbox/raster/formulas/interpolate.h>
#include <glassbox/raster/formulas/surface.h>
#include <glassbox/raster/formulas/texture.h>

}  // namespace glassbox::bounded
