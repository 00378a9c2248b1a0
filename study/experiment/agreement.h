// Compares two runs of the study: whether they agree on which of two competitors is faster for
// certain.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"

namespace glassbox::study {

struct Agreement {
  // pairs of competitors that both runs have timed with the same number of threads
  std::size_t compared = 0;
  std::size_t by_both = 0;  // pairs that both runs order by is_faster()
  std::size_t by_one = 0;
  // pairs for which the two runs say the opposite, for example "D-4, 1 thread: a before b in the
  // one, b before a in the other"
  std::vector<std::string> contradictions;
};

// An error if the runs have no experiment in common, or different configurations of the same one.
Result<Agreement> find_agreement(const StudyResults& one, const StudyResults& other);

}  // namespace glassbox::study
