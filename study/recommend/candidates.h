// Ways to draw a scene, each with its error and time on this very scene, and the cheapest that is accurate enough.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/bench/statistics.h"
#include "study/recommend/budget.h"

namespace glassbox::study {

struct Candidate {
  std::string name;                  // "float, composed once; 8 bits"
  std::vector<std::string> options;  // of glassbox render, which ask for it
  bool in_render = true;             // glassbox render can do it
  double error = 0;
  // For one item; none where it was not timed: it cannot be recommended.
  std::optional<Quartiles> ns;
};

struct Comparison {
  Quantity quantity = Quantity::kPosition;
  std::string error, reference, item;  // what is measured, against what, and what the time is per
  std::vector<Candidate> candidates;
};

// Of those that render can do, with an error below `limit`, the fastest that was timed; where there is none, of the others. Those whose
// quartiles of time reach down to the fastest's are as fast; of them the most accurate. None where no candidate is accurate enough.
std::optional<std::size_t> cheapest(const std::vector<Candidate>& candidates, double limit);

}  // namespace glassbox::study
