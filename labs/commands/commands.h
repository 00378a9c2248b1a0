// The commands of labs/ for run_program.
#pragma once

#include "cli/options/cli_fwd.h"
#include "cli/run_program.h"

namespace glassbox::labs {

inline constexpr CommandName kCommands[] = {
    {"lab", "programming assignments: start one, check it, or hand one out"},
};

void add_commands(CLI::App& app, int& exit_code);

// add_commands calls these functions to add the subcommands of `lab`. Each is in a source file of
// its name.
void add_start_command(CLI::App& lab, int& exit_code);
void add_export_command(CLI::App& lab, int& exit_code);
void add_check_command(CLI::App& lab, int& exit_code);
void add_watch_command(CLI::App& lab, int& exit_code);
void add_render_command(CLI::App& lab, int& exit_code);
void add_stiff_command(CLI::App& lab, int& exit_code);
void add_quiz_command(CLI::App& lab, int& exit_code);
void add_measure_command(CLI::App& lab, int& exit_code);
void add_gradescope_command(CLI::App& lab, int& exit_code);
void add_package_command(CLI::App& lab, int& exit_code);

}  // namespace glassbox::labs
