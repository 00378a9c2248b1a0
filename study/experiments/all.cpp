#include "study/experiments/experiments.h"

namespace glassbox::study {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
      d01_vertex_stage(),   d02_subpixel_bits(), d03_edge_arithmetic(),
      d04_perspective(),    d05_reciprocal(),    d06_depth(),
      d07_composition(),    d08_normals(),       d09_culling(),
      d10_stereo_culling(), d11_second_eye(),    d12_anaglyph(),
      d13_rotation(),       d26_tessellation(),  d27_hierarchical_raster(),
      d28_elision(),        d29_trace(),         d31_supersampling(),
      d32_clipping(),
  };
  return all;
}

}  // namespace glassbox::study
