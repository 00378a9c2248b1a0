#include "app/lab/check_command.h"

#include <chrono>
#include <system_error>
#include <thread>

#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/lab/report.h"
#include "app/options/output_options.h"
#include "app/report/exit_codes.h"
#include "app/report/output.h"
#include "labs/framework/check_lab.h"

namespace glassbox::app {

namespace {

namespace fs = std::filesystem;

struct Outputs {
  std::optional<std::string> json, html;
};

// Checks the folder once and says what came of it.
Result<int> check_once(const LabFolder& folder, const labs::CheckOptions& options,
                       const Outputs& outputs) {
  const auto sources = labs::find_sources();
  if (!sources) return tl::unexpected(sources.error());
  const auto start = std::chrono::steady_clock::now();
  labs::BuildRequest build;
  build.folder = folder.lab->folder;
  build.student = folder.student;
  build.build_dir = folder.build_dir;
  labs::LocalRunner runner;
  const auto result = labs::check_lab(*folder.lab, *sources, build, options, runner);
  if (!result) return tl::unexpected(result.error());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const LabReport report{*result, folder.student.string(),
                         result->not_built.empty() ? (folder.build_dir / "runner").string() : "",
                         took.count()};
  if (outputs.json) {
    if (const auto written = write_json(*outputs.json, lab_report_json(report)); !written)
      return tl::unexpected(written.error());
  }
  if (outputs.html) {
    const auto page = lab_report_page(report);
    if (!page) return tl::unexpected(page.error());
    if (const auto written = write_text(*outputs.html, *page); !written)
      return tl::unexpected(written.error());
  }
  if (outputs.json != "-") fmt::print("{}", lab_report_text(report));
  return result->score == result->max_score && result->not_built.empty() ? kSuccess : kFailure;
}

// When the file was last written; it may be away for a moment while an editor replaces it.
std::optional<fs::file_time_type> written_at(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  return error ? std::nullopt : std::optional(time);
}

}  // namespace

void LabCheckCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand(
      "check", "builds and runs a lab: the points, and where it first goes wrong");
  command.footer(
      "Examples:\n"
      "  glassbox lab check ~/lab5\n"
      "  glassbox lab check ~/lab5 --html report.html\n"
      "  glassbox lab check labs/05-clipping --hidden\n\n"
      "The exit code is 0 for full marks and 1 for less.");
  command.add_option("FOLDER", folder_, "made by glassbox lab start, or a lab's own")->required();
  add_json_output(command, json_output_, "the report");
  add_html_output(command, html_output_, "the report as a page with pictures");
  command.add_flag("--hidden", hidden_, "hidden checks too");
  command.add_option("--time-limit", seconds_, "seconds that a check may take")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabCheckCommand::run() const {
  const Outputs outputs{json_output_, html_output_};
  if (const auto good = check_report_outputs(outputs.html, outputs.json); !good)
    return refuse(good.error());
  const auto folder = open_lab_folder(folder_);
  if (!folder) return refuse(folder.error());
  labs::CheckOptions options;
  options.with_hidden = hidden_;
  options.limits.seconds = seconds_;
  const auto code = check_once(*folder, options, outputs);
  return code ? *code : refuse(code.error());
}

void LabWatchCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand("watch", "checks a lab again after every save");
  command.footer(
      "Examples:\n"
      "  glassbox lab watch ~/lab5\n\n"
      "Ctrl-C ends it.");
  command.add_option("FOLDER", folder_, "made by glassbox lab start, or a lab's own")->required();
  add_html_output(command, html_output_, "the last report as a page with pictures");
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabWatchCommand::run() const {
  const Outputs outputs{std::nullopt, html_output_};
  if (const auto good = check_report_outputs(outputs.html, outputs.json); !good)
    return refuse(good.error());
  const auto folder = open_lab_folder(folder_);
  if (!folder) return refuse(folder.error());
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  std::optional<fs::file_time_type> seen;
  while (true) {
    const auto now = written_at(folder->student);
    if (now && now != seen) {
      seen = now;
      if (terminal) fmt::print("\x1b[H\x1b[2J\x1b[3J");
      const auto code = check_once(*folder, labs::CheckOptions{}, outputs);
      if (!code) fmt::print("{}\n", code.error().message());
      fmt::print("\nSave {} to check it again; Ctrl-C ends.\n", folder->student.string());
      std::fflush(stdout);
    }
    // A glance at a file's time costs nothing, and works where notices of changes do not (shared folders, containers).
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

}  // namespace glassbox::app
