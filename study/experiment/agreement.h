// Whether two runs of the study state the same orders: which of two competitors is the faster one, for certain.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"

namespace glassbox::study {

struct Agreement {
  std::size_t compared = 0;  // pairs of competitors that both runs have timed with as many threads
  std::size_t by_both = 0;   // of these, in how many both state an order: is_faster()
  std::size_t by_one = 0;
  std::vector<std::string>
      contradictions;  // of those of both: "D-4, 1 thread: a before b in the one, b before a in the other"
};

// An error where the runs have no experiment in common, or different configurations of one.
Result<Agreement> agreement(const StudyResults& one, const StudyResults& other);

}  // namespace glassbox::study
