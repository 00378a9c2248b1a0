// Which configurations are worth having: no other one is both more accurate and faster.
#pragma once

#include <vector>

#include "study/experiment/results.h"

namespace glassbox::study {

enum class Standing {
  kUntimed,    // nothing to weigh the error against
  kFront,      // no competitor is better
  kDominated,  // a competitor is at least as accurate, and faster for certain
};

const char* name_of(Standing standing);  // "front"

// What one pays for what one gets.
struct Price {
  double error = 0;
  Quartiles ns;
};

// The standing of each among all of them.
std::vector<Standing> standings(const std::vector<Price>& competitors);

// Competitors have the same measure, the same scene and, unless the axis is chosen, the same parameter.
bool compete(const ExperimentResult& experiment, const ConfigurationResult& a,
             const ConfigurationResult& b);

// The standing of each configuration, by its times with that many threads. Times are ordered by is_faster(), so that another
// run on a busy machine states the same; errors are exact. An error that is no number is dominated
// by every number that takes no longer.
std::vector<Standing> standings(const ExperimentResult& experiment, int threads = 1);

// Null where the configuration was not timed with that many threads.
const Timing* timing_of(const ConfigurationResult& result, int threads);

// The numbers of threads that anything was timed with, ascending.
std::vector<int> thread_counts(const ExperimentResult& experiment);

}  // namespace glassbox::study
