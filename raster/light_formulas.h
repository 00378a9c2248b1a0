// The formulas of light and of the surfaces that it falls on, for one number at a time
// (not vectors).
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

// These formulas are in a namespace of their own, because formulas of numbers with bounds
// (bounded_formulas.h) have the same names: argument-dependent lookup would otherwise find both.
namespace single {

using glassbox::product;  // for directions; surface.h has one for colours

#include <glassbox/raster/formulas/surface.h>

#include <glassbox/raster/formulas/corners.h>

}  // namespace single
using namespace single;

}  // namespace glassbox
