#include "labs/commands/lab_command.h"

#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "labs/commands/commands.h"
#include "labs/commands/for_students.h"

namespace glassbox::labs {

void LabCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("lab");
  command.footer(
      "Examples:\n"
      "  glassbox lab list\n"
      "  glassbox lab start 5 ~/lab5\n"
      "  glassbox lab check ~/lab5\n\n"
      "docs/labs.md explains the labs.");
  command.require_subcommand(1);
  list_.add_to(command, exit_code);
  start_.add_to(command, exit_code);
  check_.add_to(command, exit_code);
  watch_.add_to(command, exit_code);
  render_.add_to(command, exit_code);
  stiff_.add_to(command, exit_code);
  quiz_.add_to(command, exit_code);
  measure_.add_to(command, exit_code);
  if (kForStudents) return;
  export_.add_to(command, exit_code);
  grade_.add_to(command, exit_code);
  gradescope_.add_to(command, exit_code);
  package_.add_to(command, exit_code);
}

void add_commands(CLI::App& app, int& exit_code) {
  add_command<LabCommand>(app, exit_code);
}

}  // namespace glassbox::labs
