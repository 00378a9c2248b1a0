#include "app/views/views_command.h"

#include <CLI/CLI.hpp>

namespace glassbox::app {

void ViewsCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command =
      *app.add_subcommand("views", "what two pictures tell of the cameras that took them");
  command.footer(
      "Examples:\n"
      "  glassbox views match --scene room --eye-separation 0.2 -o disparity.pfm\n\n"
      "docs/matching.md goes from two pictures to a disparity map, step by step.");
  command.require_subcommand(1);
  match_.add_to(command, exit_code);
}

}  // namespace glassbox::app
