#include "app/study/list_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/options/output_options.h"
#include "app/report/exit_codes.h"
#include "app/report/output.h"
#include "app/report/text_layout.h"
#include "study/experiment/experiment.h"

namespace glassbox::app {

namespace {

using study::Experiment;

nlohmann::ordered_json list_json() {
  auto json = nlohmann::ordered_json::array();
  for (const Experiment& each : study::experiments()) {
    json.push_back({{"id", each.id},
                    {"name", each.name},
                    {"question", each.question},
                    {"axis", each.axis},
                    {"error", each.error},
                    {"error_unit", each.error_unit},
                    {"reference", each.reference},
                    {"theory", each.theory},
                    {"item", each.item},
                    {"threaded", each.threaded}});
  }
  return json;
}

std::string list_text() {
  std::string text;
  for (const Experiment& each : study::experiments()) {
    text += fmt::format("{:<6}{}\n", each.id, each.name);
    text += wrapped("      ", each.question);
  }
  return text + "\nglassbox study run ID measures one of them, glassbox study run all.\n";
}

}  // namespace

void StudyListCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command = *study.add_subcommand("list", "the experiments and what they ask");
  add_json_output(command, json_output_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

int StudyListCommand::run() const {
  if (json_output_) {
    if (const auto written = write_json(*json_output_, list_json()); !written)
      return refuse(written.error());
  }
  if (json_output_ != "-") fmt::print("{}", list_text());
  return kSuccess;
}

}  // namespace glassbox::app
