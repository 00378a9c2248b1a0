#include "views/commands/layers_command.h"

#include <CLI/CLI.hpp>

namespace glassbox::views {

void ViewsLayersCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand(
      "layers", "layered depth images: several surfaces at each pixel, warped to other views");
  command.footer(
      "Examples:\n"
      "  glassbox views layers build room --size 300x300 -o room.ldi\n"
      "  glassbox views layers draw room.ldi --eye 3,2.6,3 --look-at 0,1,0 -o beside.png");
  command.require_subcommand(1);
  build_.add_to(command, exit_code);
  draw_.add_to(command, exit_code);
}

}  // namespace glassbox::views
