// glassbox study agree ONE OTHER: checks whether two runs find the same configurations faster.
#pragma once

#include <string>

#include "cli/options/cli_fwd.h"

namespace glassbox::study {

class StudyAgreeCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;

  std::string one_, other_;
};

}  // namespace glassbox::study
