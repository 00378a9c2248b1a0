// What looks at one picture: render, info, explain, step, pixel, why, trace, stereo, inspect, diff.
#pragma once

#include "cli/options/cli_fwd.h"

namespace glassbox::app {

void add_commands(CLI::App& app, int& exit_code);

}  // namespace glassbox::app
