// glassbox lab stiff: shows in which extreme cases a student's functions fail, next to the
// reference.
#pragma once

#include <optional>
#include <string>

#include "app/lab/find_lab.h"
#include "app/options/cli_fwd.h"

namespace glassbox::app {

class LabStiffCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  AskedLab asked_;
  std::optional<std::string> json_output_;
  double seconds_ = 10;
};

}  // namespace glassbox::app
