// The formulas of the pipeline's stages, each for one number or one vertex.
#pragma once

#include <array>

#include <glassbox/base/numbers.h>

namespace glassbox {

#include <glassbox/pipeline/formulas/vertex.h>

}  // namespace glassbox
