// glassbox lab stiff: shows in which extreme cases a student's functions fail, next to the
// reference.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "labs/commands/find_lab.h"

namespace glassbox::labs {

class LabStiffCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  AskedLab asked_;
  std::optional<std::string> json_output_;
  double seconds_ = 10;
};

}  // namespace glassbox::labs
