// glassbox study run: measures experiments.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "study/commands/measuring.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

class StudyRunCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;
  Result<void> check_options() const;
  Result<void> write_outputs(const study::StudyResults& results) const;

  MeasuringOptions measuring_;
  std::optional<std::string> json_output_, csv_output_;
};

}  // namespace glassbox::study
