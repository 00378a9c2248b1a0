// glassbox help [COMMAND...]: prints the same as --help after the command.
#pragma once

#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"

namespace glassbox {

class HelpCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run(const CLI::App& program) const;

  std::vector<std::string> words_;
};

// help, completion and man: they print what the commands before them have added.
void add_help_commands(CLI::App& app, int& exit_code);

}  // namespace glassbox
