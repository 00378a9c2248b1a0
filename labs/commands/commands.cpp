#include "labs/commands/commands.h"

#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "cli/options/add_command.h"
#include "cli/options/list_command.h"
#include "cli/report/shell_line.h"
#include "labs/commands/grade_command.h"
#include "labs/commands/student_build.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

double points_of(const labs::Lab& lab) {
  double points = 0;
  for (const labs::Task& task : lab.tasks) points += task.points;
  return points;
}

}  // namespace

nlohmann::ordered_json labs_json() {
  auto all = nlohmann::ordered_json::array();
  for (const labs::Lab& lab : labs::all_labs()) {
    auto tasks = nlohmann::ordered_json::array();
    for (const labs::Task& task : lab.tasks)
      tasks.push_back({{"id", task.id}, {"title", task.title}, {"points", task.points}});
    all.push_back({{"number", lab.number},
                   {"folder", lab.folder},
                   {"title", lab.title},
                   {"points", points_of(lab)},
                   {"tasks", std::move(tasks)}});
  }
  return all;
}

// glassbox lab list: the labs, their tasks and points.
std::string labs_text() {
  std::string text;
  for (const labs::Lab& lab : labs::all_labs()) {
    text += fmt::format("{:<4}{} ({:g} points)\n", lab.number, lab.title, points_of(lab));
    for (const labs::Task& task : lab.tasks)
      text += fmt::format("    {:<5}{:<58}{:>6g}\n", task.id, task.title, task.points);
  }
  if (text.empty()) text = "This program was built without labs.\n";
  return text + fmt::format("\nTo begin a lab: {} lab start NUMBER FOLDER\n", program_name());
}

void add_commands(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("lab");
  command.footer(
      "Examples:\n"
      "  glassbox lab list\n"
      "  glassbox lab start 5 ~/lab5\n"
      "  glassbox lab check ~/lab5\n\n"
      "docs/labs.md explains the labs.");
  command.require_subcommand(1);
  static ListCommand list{"the labs, their tasks and points", labs_text, labs_json};
  list.add_to(command, exit_code);
  add_start_command(command, exit_code);
  add_check_command(command, exit_code);
  add_watch_command(command, exit_code);
  add_render_command(command, exit_code);
  add_stiff_command(command, exit_code);
  add_quiz_command(command, exit_code);
  add_measure_command(command, exit_code);
  if (kStudentBuild) return;
  add_export_command(command, exit_code);
  add_command<LabGradeCommand>(command, exit_code);
  add_gradescope_command(command, exit_code);
  add_package_command(command, exit_code);
}

}  // namespace glassbox::labs
