// The commands of glassbox, grouped by subject. A program has all of them, or those of one subject,
// so that somebody who only wants to look at one picture need not wait until the rest is compiled
// (docs/building.md).
#pragma once

#include <span>

#include "cli/options/cli_fwd.h"

namespace glassbox {

// Adds subcommands to `app`. The subcommand that is run writes its exit code to `exit_code`.
using AddCommands = void (*)(CLI::App& app, int& exit_code);

struct CommandName {
  const char* name;
  const char* help;
};

// What a room of the house has for the command line, as a program has it.
struct Subject {
  std::span<const CommandName> commands;  // what --help says of those that it adds
  AddCommands add;                        // null: the program only knows their names
};

// Runs the program with the words of its command line, or calls `without_words` if there are none.
// Returns the exit code.
int run_program(std::span<const Subject> subjects, int (*without_words)(), int argc, char** argv);

}  // namespace glassbox
