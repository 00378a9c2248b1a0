// The experiments, one file each.
#pragma once

#include "study/experiment/experiment.h"

namespace glassbox::study {

#define ENTRY(name) Experiment name();
#include <experiments.inc>  // ENTRY(d01_vertex_stage) and so on, for each file (CMakeLists.txt)
#undef ENTRY

}  // namespace glassbox::study
