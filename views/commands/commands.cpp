#include "views/commands/commands.h"

#include <CLI/CLI.hpp>

namespace glassbox::views {

void add_commands(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("views");
  command.footer(
      "Examples:\n"
      "  glassbox views geometry --scene room --eye-separation 0.3\n"
      "  glassbox views triangulate --scene room --eye-separation 0.3 --noise 0.5\n"
      "  glassbox views match --scene room --eye-separation 0.2 -o disparity.pfm\n"
      "  glassbox views layers build room -o room.ldi\n"
      "  glassbox views ring teapot -o ring\n"
      "  glassbox views voxels ring -o teapot.ply\n"
      "  glassbox views polygons ring -o teapot.glb\n"
      "  glassbox views texture teapot.glb ring --each\n"
      "  glassbox views klt clouds --globe globe.glb\n"
      "  glassbox views glyphs sheet -o wall.glb\n\n"
      "docs/views.md goes from two pictures to the cameras, docs/matching.md to a disparity map,\n"
      "docs/layers.md from layers to new pictures, docs/voxels.md from many pictures to a shape,\n"
      "docs/polygons.md to its surface and its textures, docs/klt.md from bands to components,\n"
      "docs/glyphs.md from coloured discs to the camera.");
  command.require_subcommand(1);
  add_geometry_command(command, exit_code);
  add_triangulate_command(command, exit_code);
  add_match_command(command, exit_code);
  add_layers_command(command, exit_code);
  add_ring_command(command, exit_code);
  add_voxels_command(command, exit_code);
  add_polygons_command(command, exit_code);
  add_texture_command(command, exit_code);
  add_klt_command(command, exit_code);
  add_glyphs_command(command, exit_code);
}

}  // namespace glassbox::views
