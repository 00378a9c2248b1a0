// glassbox study list: the experiments.
#pragma once

#include <optional>
#include <string>

#include "app/options/cli_fwd.h"

namespace glassbox::app {

class StudyListCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;

  std::optional<std::string> json_output_;
};

}  // namespace glassbox::app
