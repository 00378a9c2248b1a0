// The commands of views/, as a program has them.
#pragma once

#include "cli/run_program.h"

namespace glassbox::views {

inline constexpr CommandName kCommands[] = {
    {"views", "what pictures of a scene are good for"},
};

void add_commands(CLI::App& app, int& exit_code);

}  // namespace glassbox::views
