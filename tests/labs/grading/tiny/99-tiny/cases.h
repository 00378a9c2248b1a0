// The inputs of both sides.
#pragma once

#include <vector>

inline std::vector<double> inputs() {
  return {1, -3, 0.5, 8};
}

// BEGIN HIDDEN
inline std::vector<double> hidden_inputs() {
  return {1, -5, 0.015625, 8};
}
// END HIDDEN
