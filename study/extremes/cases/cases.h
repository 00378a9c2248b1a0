// The cases, one file each.
#pragma once

#include "study/extremes/extreme_case.h"

namespace glassbox::study {

}  // namespace glassbox::study
