#include "study/commands/run_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "study/commands/csv.h"
#include "study/commands/text.h"
#include "study/experiment/results_json.h"
#include "study/experiment/theory.h"

namespace glassbox::study {

void StudyRunCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command = *study.add_subcommand("run", "measure experiments, or all of them");
  command.footer(
      "Examples:\n"
      "  glassbox study run D-4 --quick\n"
      "  glassbox study run --resume results.json --csv results.csv\n"
      "  glassbox study run D-1 D-2 --json -\n"
      "  glassbox study run --part 2/8 --json parts/2.json\n\n"
      "Errors are the same in every run; times are medians and quartiles of repetitions in turn.\n"
      "Exit code 1: an error is not within a factor of two of the theory, and nobody knows why.");
  add_measuring_options(command, measuring_);
  add_json_output(command, json_output_, "the results");
  command.add_option("--csv", csv_output_, "the results as comma-separated values")
      ->type_name("FILE|-");
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> StudyRunCommand::check_options() const {
  if (json_output_ == "-" && csv_output_ == "-") {
    return fail("--csv", "JSON goes to standard output already", "name a file for one of them");
  }
  std::vector<std::string> paths;
  for (const auto& output : {json_output_, csv_output_, measuring_.file}) {
    if (output && *output != "-") paths.push_back(*output);
  }
  return check_outputs(paths);
}

Result<void> StudyRunCommand::write_outputs(const study::StudyResults& results) const {
  if (csv_output_) {
    if (const auto written = write_text(*csv_output_, study_csv(results)); !written) return written;
  }
  return json_output_ ? write_json(*json_output_, results_json(results)) : Result<void>();
}

int StudyRunCommand::run() const {
  if (const auto legal = check_options(); !legal) return refuse(legal.error());
  const auto results = measure(measuring_);
  if (!results) return refuse(results.error());
  if (const auto written = write_outputs(*results); !written) return refuse(written.error());
  if (json_output_ != "-" && csv_output_ != "-") fmt::print("{}", study_text(*results));
  for (const study::ExperimentResult& each : results->experiments) {
    if (study::count_unexplained(each) > 0) return kFailure;
  }
  return kSuccess;
}

}  // namespace glassbox::study
