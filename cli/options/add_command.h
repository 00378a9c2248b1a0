// Adds a subcommand to a program.
#pragma once

#include "cli/options/cli_fwd.h"

namespace glassbox {

// Adds a command to `app`. The object lives as long as the program, because CLI11 writes the
// options' values into it and calls it back.
template <class Command>
void add_command(CLI::App& app, int& exit_code) {
  static Command command;
  command.add_to(app, exit_code);
}

}  // namespace glassbox
