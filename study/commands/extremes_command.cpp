// glassbox study extremes: draws the cases that break pipelines, and measures how errors grow
// (sweeps).
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "study/commands/commands.h"
#include "study/commands/extremes/report.h"

#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>

namespace glassbox::study {

class StudyExtremesCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;
  Result<void> check_options() const;
  Result<std::vector<const study::ExtremeCase*>> chosen_cases() const;
  Result<std::vector<const study::Sweep*>> chosen_sweeps() const;
  Result<void> write_outputs(const ExtremesReport& report) const;
  Result<void> write_pictures(const ExtremesReport& report) const;
  std::string command() const;

  std::vector<std::string> cases_;
  std::optional<std::string> one_case_, sweep_, json_output_, html_output_, picture_directory_;
};

namespace {

std::string sweep_names() {
  std::string names;
  for (const Sweep& each : study::sweeps()) names += each.name + ", ";
  return names + "all";
}

// The numbers of the cases in an id: 80 and 80 for "C-80", 80 and 86 for "C-80 to C-86".
std::pair<int, int> numbers_of(const std::string& id) {
  int first = -1, last = -1;
  const int found = std::sscanf(id.c_str(), "%*[Cc]-%d to C-%d", &first, &last);
  return {first, found == 2 ? last : first};
}

// The error for a case that does not exist. If it was left out on purpose, the error says why.
tl::unexpected<Error> no_such_case(const std::string& id) {
  const int number = numbers_of(id).first;
  for (const study::OmittedCase& each : study::omitted_cases()) {
    const auto [first, last] = numbers_of(each.id);
    if (number < 0 || number < first || number > last) continue;
    return fail(id, "is left out (" + each.name + "): " + each.reason, "choose another case");
  }
  return fail(printable(id, 40), "is not one of the cases",
              "glassbox study extremes lists all cases, such as C-43");
}

}  // namespace

void StudyExtremesCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command =
      *study.add_subcommand("extremes",
                            "tests extreme inputs that break pipelines, with our code, naive code, "
                            "and mutants (our code with one fault)");
  command.footer(
      "Examples:\n"
      "  glassbox study extremes\n"
      "  glassbox study extremes --case C-43 -o pictures\n"
      "  glassbox study extremes --sweep near-far\n"
      "  glassbox study extremes --html extremes.html\n\n"
      "Sweeps: " +
      sweep_names() +
      ".\n"
      "The exit code is 1 if our code fails, naive code passes or a mutant survives in one of the "
      "cases.\n"
      "docs/extremes.md explains the table.");
  command.add_option("CASE", cases_, "the codes of cases, such as C-43 [all]");
  command.add_option("--case", one_case_, "show one case in full")->type_name("ID");
  command.add_option("--sweep", sweep_, "show error and bound for each value of one parameter")
      ->type_name("NAME|all");
  command
      .add_option("-o", picture_directory_,
                  "write the pictures of the chosen cases into this directory")
      ->type_name("DIRECTORY");
  add_html_output(
      command, html_output_,
      "the printed output as a page, with curves and pictures; with all sweeps if no case and no "
      "sweep is chosen");
  add_json_output(command, json_output_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> StudyExtremesCommand::check_options() const {
  if (one_case_ && !cases_.empty()) {
    return fail("--case", "this option shows one case, but CASE names cases as well",
                "give only one of the two");
  }
  return check_report_outputs(html_output_, json_output_);
}

Result<std::vector<const ExtremeCase*>> StudyExtremesCommand::chosen_cases() const {
  std::vector<const ExtremeCase*> chosen;
  if (cases_.empty() && !one_case_) {
    if (sweep_) return chosen;
    for (const ExtremeCase& each : study::extreme_cases()) chosen.push_back(&each);
    return chosen;
  }
  for (const std::string& id : one_case_ ? std::vector{*one_case_} : cases_) {
    const ExtremeCase* found = study::find_case(id);
    if (found == nullptr) return no_such_case(id);
    chosen.push_back(found);
  }
  return chosen;
}

Result<std::vector<const Sweep*>> StudyExtremesCommand::chosen_sweeps() const {
  const bool nothing_chosen = cases_.empty() && !one_case_ && !sweep_;
  std::vector<const Sweep*> chosen;
  if (!sweep_ && !(nothing_chosen && html_output_)) return chosen;
  for (const Sweep& each : study::sweeps()) {
    if (!sweep_ || *sweep_ == "all" || *sweep_ == each.name) chosen.push_back(&each);
  }
  if (chosen.empty()) {
    return fail("--sweep", fmt::format("there is no sweep '{}'", printable(*sweep_, 40)),
                "choose " + sweep_names());
  }
  return chosen;
}

Result<void> StudyExtremesCommand::write_pictures(const ExtremesReport& report) const {
  std::error_code error;
  std::filesystem::create_directories(*picture_directory_, error);
  for (const study::CaseResult& result : report.cases) {
    for (const study::ExtremePicture& picture : result.extreme_case.pictures) {
      const std::string path =
          fmt::format("{}/{}-{}.png", *picture_directory_, result.extreme_case.id, picture.name);
      const std::string png = picture.png();
      if (const auto written = write_file(path, std::as_bytes(std::span(png))); !written)
        return written;
      if (json_output_ != "-") fmt::print("{}\n", path);
    }
  }
  return {};
}

std::string StudyExtremesCommand::command() const {
  std::string line = std::string(program_name()) + " study extremes";
  for (const std::string& id : cases_) line += " " + id;
  if (one_case_) line += " --case " + *one_case_;
  if (sweep_) line += " --sweep " + *sweep_;
  return line + " --html " + *html_output_;
}

Result<void> StudyExtremesCommand::write_outputs(const ExtremesReport& report) const {
  if (html_output_) {
    if (const auto written = write_text(*html_output_, extremes_page(report, command())); !written)
      return written;
  }
  if (json_output_) {
    if (const auto written = write_json(*json_output_, extremes_json(report)); !written)
      return written;
  }
  return {};
}

int StudyExtremesCommand::run() const {
  if (const auto legal = check_options(); !legal) return refuse(legal.error());
  const auto cases = chosen_cases();
  if (!cases) return refuse(cases.error());
  const auto sweeps = chosen_sweeps();
  if (!sweeps) return refuse(sweeps.error());

  Progress progress;
  ExtremesReport report;
  for (const ExtremeCase* each : *cases) {
    progress.phase(each->id + " " + each->name);
    report.cases.push_back(study::run_case(*each));
  }
  for (const Sweep* each : *sweeps) {
    progress.phase(each->title);
    report.sweeps.push_back({*each, each->series()});
  }
  progress.done();

  if (json_output_ != "-") {
    if (one_case_) fmt::print("{}", case_text(report.cases.front()));
    fmt::print("{}", extremes_text(one_case_ ? ExtremesReport{{}, report.sweeps} : report));
  }
  if (picture_directory_) {
    if (const auto written = write_pictures(report); !written) return refuse(written.error());
  }
  if (const auto written = write_outputs(report); !written) return refuse(written.error());
  if (html_output_ && json_output_ != "-") {
    fmt::print("\n{}: open it in a browser\n", *html_output_);
  }
  return report.holds() ? kSuccess : kFailure;
}

void add_extremes_command(CLI::App& study, int& exit_code) {
  add_command<StudyExtremesCommand>(study, exit_code);
}

}  // namespace glassbox::study
