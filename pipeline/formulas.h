// The formulas of the pipeline's stages, for one number at a time.
#pragma once

#include <array>

#include <glassbox/base/numbers.h>

namespace glassbox {

#include <glassbox/pipeline/formulas/vertex.h>

}  // namespace glassbox
