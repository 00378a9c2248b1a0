// The formulas of light and of the surfaces that it falls on, for one number at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glassbox/base/numbers.h>
#include <glassbox/mesh/mesh.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/raster/shading.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

// Formulas of numbers with bounds would find these, too, by arguments that both have.
namespace single {

using glassbox::product;  // of directions; there is one of colours, too

#include <glassbox/raster/formulas/surface.h>

#include <glassbox/raster/formulas/corners.h>

}  // namespace single
using namespace single;

}  // namespace glassbox
