// The commands of the folder views/, for run_program().
#pragma once

#include "cli/options/cli_fwd.h"
#include "cli/run_program.h"

namespace glassbox::views {

inline constexpr CommandName kCommands[] = {
    {"views", "find out from pictures of a scene: cameras, depth, layers, shape, colours"},
};

void add_commands(CLI::App& app, int& exit_code);

// add_commands calls these to add the subcommands of `views`. Each is defined in the source file of
// its name.
void add_geometry_command(CLI::App& views, int& exit_code);
void add_triangulate_command(CLI::App& views, int& exit_code);
void add_match_command(CLI::App& views, int& exit_code);
void add_layers_build_command(CLI::App& views, int& exit_code);
void add_layers_draw_command(CLI::App& views, int& exit_code);
void add_ring_command(CLI::App& views, int& exit_code);
void add_voxels_command(CLI::App& views, int& exit_code);
void add_polygons_command(CLI::App& views, int& exit_code);
void add_texture_command(CLI::App& views, int& exit_code);
void add_klt_command(CLI::App& views, int& exit_code);
void add_glyphs_command(CLI::App& views, int& exit_code);
void add_layers_command(CLI::App& views, int& exit_code);

}  // namespace glassbox::views
