#include "labs/commands/stiff_command.h"

#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/number_range.h"
#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "labs/commands/lab_dir.h"
#include "labs/commands/stiff_cases.h"
#include "labs/commands/student_stages.h"

namespace glassbox::labs {

namespace {

using Json = nlohmann::ordered_json;

std::string number_text(const study::Outcome& outcome) {
  return fmt::format("{:.3g}{}", outcome.error, outcome.passes() ? "" : " !");
}

std::string report_text(const labs::Lab& lab, const std::vector<StiffCase>& cases) {
  std::size_t width = 0;
  for (const StiffCase& each : cases)
    if (each.yours) width = std::max(width, each.what->name.size());
  std::string text =
      fmt::format("Lab {}: {}\n\n  {:<6}{:<{}}{:>12}{:>12}{:>12}{:>10}  {}\n", lab.number,
                  lab.title, "case", "", width, "yours", "reference", "naive", "bound", "unit");
  std::string not_put;
  for (const StiffCase& each : cases) {
    const study::ExtremeCase& what = *each.what;
    if (!each.yours) {
      not_put += (not_put.empty() ? "" : ", ") + what.id;
      continue;
    }
    text += fmt::format("  {:<6}{:<{}}{:>12}{:>12}{:>12}{:>10.3g}  {}\n", what.id, what.name, width,
                        each.broke.empty() ? number_text(*each.yours) : "ended !",
                        number_text(*each.reference), number_text(each.naive), each.yours->bound,
                        what.unit);
  }
  text += "\n! is beyond the bound. Naive code is measured by itself, without a picture.\n";
  for (const StiffCase& each : cases) {
    if (each.out_of_reach())
      text +=
          fmt::format("{}: the reference is beyond the bound too: your contracts ask for less.\n",
                      each.what->id);
    if (!each.gives_up()) continue;
    text +=
        fmt::format("{}: {}\n", each.what->id, each.broke.empty() ? each.yours->seen : each.broke);
    text += fmt::format("  glassbox study extremes --case {}\n", each.what->id);
  }
  if (!not_put.empty())
    text += fmt::format("Not put to your functions, as no picture of this lab shows it: {}.\n",
                        not_put);
  return text;
}

Json outcome_json(const study::Outcome& outcome) {
  return {{"error", outcome.error}, {"bound", outcome.bound}, {"seen", outcome.seen}};
}

Json report_json(const labs::Lab& lab, const std::vector<StiffCase>& cases) {
  Json json{{"lab", lab.folder}, {"cases", Json::array()}};
  for (const StiffCase& each : cases) {
    Json one{{"id", each.what->id}, {"name", each.what->name}, {"unit", each.what->unit}};
    if (each.yours) {
      one["yours"] = outcome_json(*each.yours);
      one["reference"] = outcome_json(*each.reference);
      one["naive"] = outcome_json(each.naive);
      one["gives_up"] = each.gives_up();
      if (!each.broke.empty()) one["ended"] = each.broke;
    }
    json["cases"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

void LabStiffCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand(
      "stiff", "the cases of your lab that break pipelines: where your functions give up");
  command.footer(
      "Examples:\n"
      "  glassbox lab stiff ~/lab6\n\n"
      "Each case that the handout names and a picture shows is drawn with your functions in the\n"
      "pipeline, and judged as glassbox study extremes judges it. The exit code is 0 where all "
      "hold\nthat hold with the reference's.");
  command.add_option("FOLDER", asked_.folder, "made by glassbox lab start, or a lab's own")
      ->required();
  add_lab_name(command, asked_.lab);
  add_json_output(command, json_output_, "the report");
  command.add_option("--time-limit", seconds_, "seconds that a stage of yours may take")
      ->check(number_between(0.1, 3600))
      ->capture_default_str();
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabStiffCommand::run() const {
  if (const auto good = check_report_outputs({}, json_output_); !good) return refuse(good.error());
  const auto folder = open_lab_folder(asked_);
  if (!folder) return refuse(folder.error());
  const auto drawing = labs::drawing_of(folder->lab->number);
  const auto sources = labs::find_sources();
  if (!sources) return refuse(sources.error());
  const auto cases = cases_of_lab(*sources, *folder->lab);
  if (!cases) return refuse(cases.error());
  if (!drawing || cases->empty())
    return refuse(
        {asked_.folder, "", "this lab has no stiff cases", "name the folder of another lab"});
  Progress progress;
  StudentStages stages;
  if (const auto built = stages.build(*sources, *folder, progress); !built)
    return refuse(built.error());
  if (stages.program().program.empty()) {
    progress.done();
    fmt::print("{}", stages.program().messages);
    return kFailure;
  }
  std::vector<StiffCase> put;
  for (const study::ExtremeCase* each : *cases) {
    progress.phase("putting " + each->id);
    put.push_back(
        put_case(*each, *folder->lab, *drawing, stages.sandbox(), stages.program(), seconds_));
  }
  progress.done();
  if (std::none_of(put.begin(), put.end(), [](const auto& c) { return c.yours.has_value(); }))
    return refuse({asked_.folder, "", "no picture of this lab shows one of its stiff cases",
                   fmt::format("look at one by itself: glassbox study extremes --case {}",
                               put.front().what->id)});
  if (json_output_) {
    if (const auto made = write_json(*json_output_, report_json(*folder->lab, put)); !made)
      return refuse(made.error());
  }
  if (json_output_ != "-") fmt::print("{}", report_text(*folder->lab, put));
  return std::any_of(put.begin(), put.end(), [](const auto& c) { return c.gives_up(); }) ? kFailure
                                                                                         : kSuccess;
}

}  // namespace glassbox::labs
