// glassbox lab measure: runs an experiment with a student's functions as one more series.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "labs/commands/find_lab.h"

namespace glassbox::labs {

class LabMeasureCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  AskedLab asked_;
  std::optional<std::string> json_output_, html_output_, against_;
  double seconds_ = 60;
};

}  // namespace glassbox::labs
