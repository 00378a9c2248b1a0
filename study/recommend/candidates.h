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
  // For one item; none where it was not timed.
  std::optional<Quartiles> ns;
};

struct Comparison {
  Quantity quantity = Quantity::kPosition;
  std::string error, reference, item;  // what is measured, against what, and what the time is per
  std::vector<Candidate> candidates;
};

// Of those with an error below `limit` the fastest that was timed. Those whose quartiles of time reach down to the fastest's are
// as fast; of them the most accurate. None where no candidate is accurate enough.
std::optional<std::size_t> cheapest(const std::vector<Candidate>& candidates, double limit);

// Of those with an error below `limit` the first that render can do; where there is none, the first of the others.
std::optional<std::size_t> nearest_to_render(const std::vector<Candidate>& candidates,
                                             double limit);

}  // namespace glassbox::study
