// The inputs, for the runner and for the judge.
#pragma once

#include <vector>

#include "labs/framework/varied_inputs.h"

inline std::vector<double> inputs() {
  return {1, -3, 0.5, 8};
}

// BEGIN HIDDEN
inline std::vector<double> hidden_inputs() {
  return glassbox::labs::with_varied(
      std::vector<double>{1, -5, 0.015625, 8}, 99, 3,
      [](glassbox::Random& random) { return double(random.integer(1, 1000)); });
}
// END HIDDEN
