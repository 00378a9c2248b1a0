// The options of the subcommands that measure experiments, and the measuring.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/cli_fwd.h"
#include "study/experiment/results.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

struct MeasuringOptions {
  std::vector<std::string> ids;  // none: all experiments
  bool quick = false;
  std::optional<int> threads;
  std::optional<std::string> file;  // to go on from
  int part = 1, parts = 1;          // every parts-th of them, from the part-th on
};

void add_measuring_options(CLI::App& command, MeasuringOptions& options);

// With progress on standard error. An experiment that there is not is an error, before anything is measured.
Result<study::StudyResults> measure(const MeasuringOptions& options);

// Those of the results that are named; one that they do not have is an error.
Result<study::StudyResults> chosen_of(const study::StudyResults& results,
                                      const std::vector<std::string>& ids);

}  // namespace glassbox::app
