#include "study/commands/commands.h"

#include <string>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "cli/options/add_command.h"
#include "cli/options/list_command.h"
#include "cli/report/text_layout.h"
#include "study/commands/bench/bench_command.h"
#include "study/experiment/experiment.h"

namespace glassbox::study {

nlohmann::ordered_json experiments_json() {
  auto json = nlohmann::ordered_json::array();
  for (const study::Experiment& each : study::experiments()) {
    auto measures = nlohmann::ordered_json::array();
    for (const study::Measure& measure : each.measures) {
      measures.push_back({{"name", measure.name},
                          {"error", measure.error},
                          {"error_unit", measure.error_unit},
                          {"axis", measure.axis.empty() ? each.axis : measure.axis}});
    }
    json.push_back({{"id", each.id},
                    {"name", each.name},
                    {"question", each.question},
                    {"axis", each.axis},
                    {"error", each.error},
                    {"error_unit", each.error_unit},
                    {"reference", each.reference},
                    {"measures", std::move(measures)},
                    {"theory", each.theory},
                    {"item", each.item},
                    {"threaded", each.threaded}});
  }
  return json;
}

// glassbox study list: the experiments, and the question that each answers.
std::string experiments_text() {
  std::string text;
  for (const study::Experiment& each : study::experiments()) {
    text += fmt::format("{:<6}{}\n", each.id, each.name);
    text += wrapped("      ", each.question);
  }
  return text + "\nglassbox study run ID measures one of them, glassbox study run measures all.\n";
}

void add_commands(CLI::App& app, int& exit_code) {
  add_command<BenchCommand>(app, exit_code);
  add_command<BenchPeerCommand>(app, exit_code);
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
  static ListCommand list{"lists the experiments and their questions", experiments_text,
                          experiments_json};
  list.add_to(command, exit_code);
  add_run_command(command, exit_code);
  add_collect_command(command, exit_code);
  add_agree_command(command, exit_code);
  add_report_command(command, exit_code);
  add_extremes_command(command, exit_code);
  add_scene_command(command, exit_code);
  add_recommend_command(command, exit_code);
  add_stiffness_command(command, exit_code);
}

}  // namespace glassbox::study
