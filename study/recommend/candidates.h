// Compares ways to draw a scene by their error and time on this scene, and finds the cheapest one
// that is accurate enough.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/bench/statistics.h"
#include "study/recommend/budget.h"

namespace glassbox::study {

struct Candidate {
  std::string name;                  // for example "float, composed once; 8 bits"
  std::vector<std::string> options;  // options of glassbox render that select it
  bool in_render = true;             // whether glassbox render offers it
  double error = 0;
  // Time per item; none if it was not timed.
  std::optional<Quartiles> ns;
};

struct Comparison {
  Quantity quantity = Quantity::kPosition;
  // What is measured, what it is compared with, and what is timed.
  std::string error, reference, item;
  std::vector<Candidate> candidates;
};

// The fastest timed candidate with an error below `limit`. Candidates whose quartiles of time
// overlap with those of the fastest count as equally fast; among them the most accurate one is
// chosen. None if no candidate is accurate enough.
std::optional<std::size_t> fastest_candidate(const std::vector<Candidate>& candidates,
                                             double limit);

// The first candidate with an error below `limit` that glassbox render offers; if there is none,
// the first of the other candidates below `limit`.
std::optional<std::size_t> first_render_candidate(const std::vector<Candidate>& candidates,
                                                  double limit);

}  // namespace glassbox::study
