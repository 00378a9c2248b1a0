// glassbox help [COMMAND...]: prints the same as --help after the command.
#pragma once

#include "cli/options/cli_fwd.h"

namespace glassbox {

// Adds help, completion and man, which print what the commands added before them have. Call it
// last.
void add_help_commands(CLI::App& app, int& exit_code);
void add_completion_command(CLI::App& app, int& exit_code);
void add_man_command(CLI::App& app, int& exit_code);

}  // namespace glassbox
