// Runs an experiment by the protocol of SPEC D.
#pragma once

#include <functional>
#include <string>

#include "study/experiment/experiment.h"
#include "study/experiment/results.h"

namespace glassbox::study {

// Fewer say little about quartiles.
inline constexpr int kLeastRepetitions = 11;

struct RunOptions {
  Effort effort = Effort::kQuick;
  int repetitions = kLeastRepetitions;
  int threads = 1;                                // the most
  std::function<void(const std::string&)> phase;  // told what is being done; may be empty
};

// Errors once each; times with one thread, then, where the experiment has a use for them, with all.
ExperimentResult run_experiment(const Experiment& experiment, const RunOptions& options);

// Null where there is none; in either case of letters.
const Experiment* find_experiment(const std::vector<Experiment>& all, const std::string& id);

// Where results come from that this program measures on this machine.
Origin origin_here(const std::string& version, Effort effort, int threads);

}  // namespace glassbox::study
