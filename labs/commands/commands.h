// The commands of labs/, as a program has them.
#pragma once

#include "cli/run_program.h"

namespace glassbox::labs {

inline constexpr CommandName kCommands[] = {
    {"lab", "assignments: start one, check it, hand one out"},
};

void add_commands(CLI::App& app, int& exit_code);

}  // namespace glassbox::labs
