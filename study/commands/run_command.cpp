// glassbox study run: measures experiments.
#include <optional>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "study/commands/commands.h"
#include "study/commands/measuring.h"
#include "study/commands/report.h"
#include "study/experiment/results_json.h"
#include "study/experiment/theory.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

class StudyRunCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;
  Result<void> check_options() const;
  Result<void> write_outputs(const study::StudyResults& results) const;

  MeasuringOptions measuring_;
  std::optional<std::string> json_output_, csv_output_;
};

void StudyRunCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command =
      *study.add_subcommand("run", "measures the named experiments, or all of them");
  command.footer(
      "Examples:\n"
      "  glassbox study run D-4 --quick\n"
      "  glassbox study run --resume results.json --csv results.csv\n"
      "  glassbox study run D-1 D-2 --json -\n"
      "  glassbox study run --part 2/8 --json parts/2.json\n\n"
      "Errors are the same in every run. Times are medians and quartiles of repetitions.\n"
      "The exit code is 1 if a measured error is more than twice or less than half of what the "
      "theory\n"
      "predicts, and the experiment gives no reason for it.");
  add_measuring_options(command, measuring_);
  add_json_output(command, json_output_, "the results");
  command.add_option("--csv", csv_output_, "the results as comma-separated values")
      ->type_name("FILE|-");
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> StudyRunCommand::check_options() const {
  if (json_output_ == "-" && csv_output_ == "-") {
    return fail("--csv", "standard output already gets the JSON", "name a file for one of the two");
  }
  return Outputs().data(json_output_).data(csv_output_).data(measuring_.file).check();
}

Result<void> StudyRunCommand::write_outputs(const study::StudyResults& results) const {
  if (csv_output_) {
    if (const auto written = write_text(*csv_output_, study_csv(results)); !written) return written;
  }
  return json_output_ ? write_json(*json_output_, results_json(results)) : Result<void>();
}

int StudyRunCommand::run() const {
  if (const auto legal = check_options(); !legal) return refuse(legal.error());
  const auto results = measure_experiments(measuring_);
  if (!results) return refuse(results.error());
  if (const auto written = write_outputs(*results); !written) return refuse(written.error());
  if (json_output_ != "-" && csv_output_ != "-") fmt::print("{}", study_text(*results));
  for (const study::ExperimentResult& each : results->experiments) {
    if (study::count_unexplained(each) > 0) return kFailure;
  }
  return kSuccess;
}

void add_run_command(CLI::App& study, int& exit_code) {
  add_command<StudyRunCommand>(study, exit_code);
}

}  // namespace glassbox::study
