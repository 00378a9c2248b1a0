// glassbox help [COMMAND...]: prints the same as --help after the command.
#pragma once

#include "cli/options/cli_fwd.h"

namespace glassbox {

// Adds the commands help, completion and man. They print what the commands that were added before
// them have, so call it last.
void add_help_commands(CLI::App& app, int& exit_code);
void add_completion_command(CLI::App& app, int& exit_code);
void add_man_command(CLI::App& app, int& exit_code);

}  // namespace glassbox
