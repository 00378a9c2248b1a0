// The commands of study/ for run_program.
#pragma once

#include "cli/options/cli_fwd.h"
#include "cli/run_program.h"

namespace glassbox::study {

inline constexpr CommandName kCommands[] = {
    {"bench",
     "measure how fast scenes are drawn, compared with other renderers, and how time grows"},
    {"study", "measure what accuracy costs: errors and times, compared with the theory"},
};

void add_commands(CLI::App& app, int& exit_code);

// add_commands calls these functions to add the subcommands of `study`. Each is in a source file of
// its name.
void add_run_command(CLI::App& study, int& exit_code);
void add_collect_command(CLI::App& study, int& exit_code);
void add_agree_command(CLI::App& study, int& exit_code);
void add_report_command(CLI::App& study, int& exit_code);
void add_extremes_command(CLI::App& study, int& exit_code);
void add_scene_command(CLI::App& study, int& exit_code);
void add_recommend_command(CLI::App& study, int& exit_code);
void add_stiffness_command(CLI::App& study, int& exit_code);

}  // namespace glassbox::study
