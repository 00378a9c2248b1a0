// glassbox lab stiff: where a student's functions give up, beside the reference.
#pragma once

#include <optional>
#include <string>

#include "app/options/cli_fwd.h"

namespace glassbox::app {

class LabStiffCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string folder_;
  std::optional<std::string> json_output_;
  double seconds_ = 10;
};

}  // namespace glassbox::app
