// Adds the commands about one picture: render, info, explain, step, pixel, why, trace, stereo,
// inspect, diff.
#pragma once

#include "cli/options/cli_fwd.h"

namespace glassbox::app {

void add_commands(CLI::App& app, int& exit_code);

// The functions that add_commands calls. add_render_command is in the folder app/render, and so on.
void add_render_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
void add_explain_command(CLI::App& app, int& exit_code);
void add_step_command(CLI::App& app, int& exit_code);
void add_pixel_command(CLI::App& app, int& exit_code);
void add_why_command(CLI::App& app, int& exit_code);
void add_trace_command(CLI::App& app, int& exit_code);
void add_stereo_command(CLI::App& app, int& exit_code);
void add_inspect_command(CLI::App& app, int& exit_code);
void add_diff_command(CLI::App& app, int& exit_code);

}  // namespace glassbox::app
