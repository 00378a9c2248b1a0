// glassbox study run: measures experiments.
#pragma once

#include <optional>
#include <string>

#include "app/options/cli_fwd.h"
#include "app/study/measuring.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

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

}  // namespace glassbox::app
