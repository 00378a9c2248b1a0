// glassbox lab list: the labs and their tasks.
#pragma once

#include <optional>
#include <string>

#include "app/options/cli_fwd.h"

namespace glassbox::app {

class LabListCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::optional<std::string> json_output_;
};

}  // namespace glassbox::app
