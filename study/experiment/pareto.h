// Finds the configurations that are worth having: no other one is both at least as accurate and
// faster (the Pareto front).
#pragma once

#include <vector>

#include "study/experiment/results.h"

namespace glassbox::study {

enum class Standing {
  kUntimed,    // has no time to compare
  kFront,      // no competitor is better
  kDominated,  // a competitor is at least as accurate, and certainly faster
};

const char* name_of(Standing standing);  // for example "front"

// The error and the time of one competitor.
struct ErrorAndTime {
  double error = 0;
  Quartiles ns;
};

// The standing of each competitor (whether it is on the Pareto front) if all of them compete.
std::vector<Standing> standings(const std::vector<ErrorAndTime>& competitors);

// Whether two configurations compete: same measure, same scene and, unless the axis is chosen, the
// same parameter.
bool are_competitors(const ExperimentResult& experiment, const ConfigurationResult& a,
                     const ConfigurationResult& b);

// The standing of each configuration, by its times with this number of threads. Times are ordered
// by is_faster(), so that another run on a busy machine gives the same standings; errors are
// compared exactly. A configuration whose error is NaN is dominated by every configuration that has
// a number as its error and is not slower.
std::vector<Standing> standings(const ExperimentResult& experiment, int threads = 1);

// Null if the configuration was not timed with this number of threads.
const Timing* timing_of(const ConfigurationResult& result, int threads);

// All numbers of threads with which something was timed, ascending.
std::vector<int> thread_counts(const ExperimentResult& experiment);

}  // namespace glassbox::study
