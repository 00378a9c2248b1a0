// The checks of tasks 8.5 and 8.6.
#pragma once

#include <vector>

#include "labs/framework/lab.h"

namespace glassbox::labs {

std::vector<Check> surface_checks();

}  // namespace glassbox::labs
