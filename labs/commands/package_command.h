// glassbox lab package: writes a copy of this glassbox without the parts that students must not
// see.
#pragma once

#include <string>

#include "cli/options/cli_fwd.h"

namespace glassbox::labs {

class LabPackageCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string output_;
  bool students_ = false;
};

}  // namespace glassbox::labs
