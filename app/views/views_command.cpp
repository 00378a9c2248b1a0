#include "app/views/views_command.h"

#include <CLI/CLI.hpp>

namespace glassbox::app {

void ViewsCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command =
      *app.add_subcommand("views", "what two pictures tell of the cameras that took them");
  command.footer(
      "Examples:\n"
      "  glassbox views geometry --scene room --eye-separation 0.3\n"
      "  glassbox views geometry --matches matches.csv --cameras cameras.txt\n\n"
      "docs/views.md goes from two pictures to the cameras, step by step.");
  command.require_subcommand(1);
  geometry_.add_to(command, exit_code);
}

}  // namespace glassbox::app
