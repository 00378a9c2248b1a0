#include "study/experiments/experiments.h"

namespace glassbox::study {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
      d01_vertex_stage(),
      d02_subpixel_bits(),
      d03_edge_arithmetic(),
      d04_perspective(),
      d05_reciprocal(),
      d07_composition(),
      d08_normals(),
      d13_rotation(),
      d26_tessellation(),
  };
  return all;
}

}  // namespace glassbox::study
