// glassbox study collect DIRECTORY: joins the parts of a run.
#pragma once

#include <string>

#include "cli/options/cli_fwd.h"

namespace glassbox::study {

class StudyCollectCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;

  std::string directory_, output_;
  bool any_machine_ = false;
};

}  // namespace glassbox::study
