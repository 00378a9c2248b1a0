// The experiments, one file each.
#pragma once

#include "study/experiment/experiment.h"

namespace glassbox::study {

}  // namespace glassbox::study
