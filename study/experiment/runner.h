// Runs an experiment: measures all errors, then times the work as described in timing.h.
#pragma once

#include <functional>
#include <string>

#include "study/experiment/experiment.h"
#include "study/experiment/results.h"

namespace glassbox::study {

// With fewer repetitions than these, quartiles mean little.
inline constexpr int kMinRepetitions = 11;

struct RunOptions {
  Effort effort = Effort::kQuick;
  int repetitions = kMinRepetitions;
  int threads = 1;  // the largest number of threads
  // called with a description of each step; may be empty
  std::function<void(const std::string&)> phase;
};

// Measures each error once, and the times with one thread; then, if the experiment can use several
// threads, the times with all threads.
ExperimentResult run_experiment(const Experiment& experiment, const RunOptions& options);

// Null if no experiment has this id; upper and lower case count as the same.
const Experiment* find_experiment(const std::vector<Experiment>& all, const std::string& id);

// The origin of results that this program measures on this machine.
Origin current_origin(const std::string& version, Effort effort, int threads);

}  // namespace glassbox::study
