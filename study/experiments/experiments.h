// The experiments, one file each.
#pragma once

#include "study/experiment/experiment.h"

namespace glassbox::study {

Experiment d01_vertex_stage();
Experiment d02_subpixel_bits();
Experiment d03_edge_arithmetic();
Experiment d04_perspective();
Experiment d05_reciprocal();
Experiment d07_composition();
Experiment d08_normals();
Experiment d13_rotation();
Experiment d26_tessellation();

}  // namespace glassbox::study
