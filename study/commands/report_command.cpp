// glassbox study report: writes the results as a page, and as pictures for papers and slides.
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/shell_line.h"
#include "study/commands/commands.h"
#include "study/commands/measuring.h"
#include "study/commands/report.h"
#include "study/experiment/result_file.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

class StudyReportCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;
  Result<void> check_options() const;
  Result<study::StudyResults> results() const;
  std::string command() const;

  MeasuringOptions measuring_;
  std::optional<std::string> from_, page_, svg_directory_;
};

void StudyReportCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command =
      *study.add_subcommand("report", "makes charts and tables of experiments as one HTML page");
  command.footer(
      "Examples:\n"
      "  glassbox study report --quick -o report.html\n"
      "  glassbox study run --resume results.json\n"
      "  glassbox study report --from results.json -o report.html --svg charts\n\n"
      "The page works without other files and without a network.");
  add_measuring_options(command, measuring_);
  command.add_option("--from", from_, "show these results of study run instead of measuring")
      ->type_name("FILE");
  command.add_option("-o,--output", page_, "the page")->type_name("FILE");
  command
      .add_option("--svg", svg_directory_,
                  "each chart as an SVG file in this directory, by gnuplot")
      ->type_name("DIRECTORY");
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> StudyReportCommand::check_options() const {
  if (!page_ && !svg_directory_) {
    return fail("", "no output is named", "give -o report.html, --svg DIRECTORY, or both");
  }
  if (from_ && (measuring_.quick || measuring_.threads || measuring_.file)) {
    return fail("--from", "this option shows results that are measured already",
                "leave --quick, --threads and --resume out");
  }
  if (svg_directory_ && !std::filesystem::is_directory(*svg_directory_)) {
    return fail("--svg", *svg_directory_ + " is not a directory", "make this directory first");
  }
  return check_report_outputs(page_, measuring_.file);
}

Result<study::StudyResults> StudyReportCommand::results() const {
  if (!from_) return measure_experiments(measuring_);
  auto kept = study::read_results(*from_);
  return kept && !measuring_.ids.empty() ? select_results(*kept, measuring_.ids) : kept;
}

// The command line that makes the page again, from stored results or by measuring.
std::string StudyReportCommand::command() const {
  std::vector<std::string> words{"study", "report"};
  words.insert(words.end(), measuring_.ids.begin(), measuring_.ids.end());
  if (measuring_.quick) words.emplace_back("--quick");
  const auto add = [&](const char* option, const std::optional<std::string>& value) {
    if (value) words.insert(words.end(), {option, *value});
  };
  if (measuring_.threads) add("--threads", fmt::to_string(*measuring_.threads));
  add("--resume", measuring_.file);
  add("--from", from_);
  add("-o", page_);
  return shell_line({words});
}

int StudyReportCommand::run() const {
  if (const auto legal = check_options(); !legal) return refuse(legal.error());
  if (svg_directory_) {
    if (const auto here = check_gnuplot(); !here) return refuse(here.error());
  }
  const auto measured = results();
  if (!measured) return refuse(measured.error());
  if (page_) {
    const auto written = write_text(*page_, study_page(*measured, command()));
    if (!written) return refuse(written.error());
    fmt::print("{}: open it in a browser\n", *page_);
  }
  if (svg_directory_) {
    const auto written = write_svg_charts(*measured, *svg_directory_);
    if (!written) return refuse(written.error());
    fmt::print("{}: {} charts\n", *svg_directory_, *written);
  }
  return kSuccess;
}

void add_report_command(CLI::App& study, int& exit_code) {
  add_command<StudyReportCommand>(study, exit_code);
}

}  // namespace glassbox::study
