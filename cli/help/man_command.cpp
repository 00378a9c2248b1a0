#include "cli/help/man_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/help/man_page.h"
#include "cli/report/exit_codes.h"

namespace glassbox {

void ManCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("man", "the manual page, for man and groff");
  command.footer(
      "Examples:\n"
      "  glassbox man | man -l -\n"
      "  glassbox man > ~/.local/share/man/man1/glassbox.1\n\n"
      "cmake --install puts it where man looks for it.");
  command.callback([&app, &exit_code] {
    fmt::print("{}", man_page(command_tree(app), GLASSBOX_VERSION));
    exit_code = kSuccess;
  });
}

}  // namespace glassbox
