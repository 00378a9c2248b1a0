// The commands of study/, as a program has them.
#pragma once

#include "cli/run_program.h"

namespace glassbox::study {

inline constexpr CommandName kCommands[] = {
    {"bench", "how fast it draws, against whom, and how its time grows"},
    {"study", "what accuracy costs: measured errors and times beside the theory"},
};

void add_commands(CLI::App& app, int& exit_code);

}  // namespace glassbox::study
