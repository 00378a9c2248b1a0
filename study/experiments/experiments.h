// The list of all experiments; each is in its own file.
#pragma once

#include "study/experiment/experiment.h"

namespace glassbox::study {

#define ENTRY(name) Experiment name();
// has ENTRY(d01_vertex_stage) and so on, one for each file (CMakeLists.txt)
#include <experiments.inc>
#undef ENTRY

}  // namespace glassbox::study
