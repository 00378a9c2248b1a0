// Runs a program with the commands of all subjects, or of only one subject: somebody who needs only
// these commands then does not have to wait until the rest is compiled (docs/building.md).
#pragma once

#include <span>

#include "cli/options/cli_fwd.h"

namespace glassbox {

// Adds subcommands to `app`. The one that is run writes its exit code to `exit_code`.
using AddCommands = void (*)(CLI::App& app, int& exit_code);

struct CommandName {
  const char* name;
  const char* help;
};

// The commands of one top-level folder (such as views/), as a program includes them.
struct Subject {
  std::span<const CommandName> commands;  // names and help texts of the commands that `add` adds
  AddCommands add;                        // null: the program only lists their names
};

// Runs the program with its command-line arguments, or calls `without_arguments` if there are none.
// Returns the exit code.
int run_program(std::span<const Subject> subjects, int (*without_arguments)(), int argc,
                char** argv);

}  // namespace glassbox
