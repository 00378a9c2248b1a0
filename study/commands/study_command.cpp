#include "study/commands/study_command.h"

#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "study/commands/bench/bench_command.h"
#include "study/commands/commands.h"

namespace glassbox::study {

void StudyCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("study");
  command.footer(
      "Examples:\n"
      "  glassbox study list\n"
      "  glassbox study run D-4 --quick\n"
      "  glassbox study report --quick -o report.html\n"
      "  glassbox study extremes\n"
      "  glassbox study scene room --html room.html\n"
      "  glassbox study recommend forest --error-budget 'depth<1e-4, colour<1/100'\n"
      "  glassbox study stiffness room\n\n"
      "docs/study.md explains how errors and times are measured.");
  command.require_subcommand(1);
  list_.add_to(command, exit_code);
  run_.add_to(command, exit_code);
  collect_.add_to(command, exit_code);
  agree_.add_to(command, exit_code);
  report_.add_to(command, exit_code);
  extremes_.add_to(command, exit_code);
  scene_.add_to(command, exit_code);
  recommend_.add_to(command, exit_code);
  stiffness_.add_to(command, exit_code);
}

void add_commands(CLI::App& app, int& exit_code) {
  add_command<BenchCommand>(app, exit_code);
  add_command<BenchPeerCommand>(app, exit_code);
  add_command<StudyCommand>(app, exit_code);
}

}  // namespace glassbox::study
