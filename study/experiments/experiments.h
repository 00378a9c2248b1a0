// The experiments, one file each.
#pragma once

#include "study/experiment/experiment.h"

namespace glassbox::study {

Experiment d01_vertex_stage();
Experiment d02_subpixel_bits();
Experiment d03_edge_arithmetic();
Experiment d04_perspective();
Experiment d05_reciprocal();
Experiment d06_depth();
Experiment d07_composition();
Experiment d08_normals();
Experiment d09_culling();
Experiment d10_stereo_culling();
Experiment d11_second_eye();
Experiment d12_anaglyph();
Experiment d13_rotation();
Experiment d26_tessellation();
Experiment d27_hierarchical_raster();
Experiment d28_elision();
Experiment d29_trace();
Experiment d31_supersampling();
Experiment d32_clipping();

}  // namespace glassbox::study
