// The options of the subcommands that measure experiments, and the measuring itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "study/experiment/results.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

struct MeasuringOptions {
  std::vector<std::string> ids;  // empty: all experiments
  bool quick = false;
  std::optional<int> threads;
  std::optional<std::string> file;  // results of a run to continue
  int part = 1, parts = 1;          // measures every parts-th experiment, starting with the part-th
};

void add_measuring_options(CLI::App& command, MeasuringOptions& options);

// Measures the experiments and shows progress on standard error. An unknown experiment is an error
// before anything is measured.
Result<study::StudyResults> measure_experiments(const MeasuringOptions& options);

// The results of the experiments that `ids` names. An error if one of these is missing.
Result<study::StudyResults> select_results(const study::StudyResults& results,
                                           const std::vector<std::string>& ids);

}  // namespace glassbox::study
