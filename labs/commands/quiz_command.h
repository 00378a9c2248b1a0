// glassbox lab quiz: asks the slides' true/false questions and explains what is wrong with an
// answer.
#pragma once

#include <string>

#include "cli/options/cli_fwd.h"

namespace glassbox::labs {

class LabQuizCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string lab_;
  std::optional<std::string> answers_;
  bool show_ = false;
};

}  // namespace glassbox::labs
