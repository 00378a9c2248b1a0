// glassbox views layers: makes layered depth images, and draws them from other views.
#include <CLI/CLI.hpp>

#include "views/commands/commands.h"

namespace glassbox::views {

void add_layers_command(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand("layers",
                                            "make layered depth images, which have several "
                                            "surfaces at each pixel, and warp them to other views");
  command.footer(
      "Examples:\n"
      "  glassbox views layers build room --size 300x300 -o room.ldi\n"
      "  glassbox views layers draw room.ldi --eye 3,2.6,3 --look-at 0,1,0 -o beside.png");
  command.require_subcommand(1);
  add_layers_build_command(command, exit_code);
  add_layers_draw_command(command, exit_code);
}

}  // namespace glassbox::views
