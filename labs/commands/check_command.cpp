// glassbox lab check: builds a student's folder, runs its checks and reports what is right.
// glassbox lab watch: does so again after every save, or draws a scene again.
#include <unistd.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "labs/commands/checker.h"
#include "labs/commands/commands.h"
#include "labs/commands/draw_picture.h"
#include "labs/commands/find_lab.h"
#include "labs/commands/report.h"
#include "labs/commands/student_build.h"

namespace glassbox::labs {

class LabCheckCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  LabSelection selection_;
  std::optional<std::string> json_output_, html_output_;
  CheckOptions options_;
};

class LabWatchCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  int watch_picture() const;

  LabSelection selection_;
  std::string scene_, output_;
  PictureOptions picture_;
  std::optional<std::string> html_output_;
  CheckOptions options_;
};

namespace {

namespace fs = std::filesystem;
using labs::grading::Confinement;

struct ReportFiles {
  std::optional<std::string> json, html;
};

// Checks the folder once and reports the result. The exit code is kSuccess for full points.
Result<int> check_once(LabChecker& checker, const ReportFiles& outputs) {
  const auto checked = checker.check();
  if (!checked) return tl::unexpected(checked.error());
  const LabReport report{checked->graded.result, checker.student().string(), checked->runner,
                         checked->seconds, checked->graded.check_outcomes};
  if (outputs.json) {
    if (const auto written = write_json(*outputs.json, lab_report_json(report)); !written)
      return tl::unexpected(written.error());
  }
  if (outputs.html) {
    if (const auto written = write_text_result(*outputs.html, lab_report_page(report)); !written)
      return tl::unexpected(written.error());
  }
  if (outputs.json != "-") fmt::print("{}", lab_report_text(report));
  const labs::LabResult& result = checked->graded.result;
  return result.score == result.max_score && result.not_built.empty() ? kSuccess : kFailure;
}

// When the file was last written; none if it does not exist, which can happen briefly while an
// editor replaces it.
std::optional<fs::file_time_type> written_at(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  return error ? std::nullopt : std::optional(time);
}

void add_options(CLI::App& command, CheckOptions& options, LabSelection& selection) {
  add_lab_dir(command, selection.lab_dir)->excludes(add_lab_name(command, selection.lab));
  command.add_flag("--sanitize", options.sanitize,
                   "compile with AddressSanitizer and UndefinedBehaviorSanitizer, which name the "
                   "line of a bad access");
  command.add_option("--time-limit", options.seconds, "time limit of a check, in seconds")
      ->check(number_between(0.1, 3600))
      ->capture_default_str();
  command.add_option("--memory-limit", options.memory_mib, "memory limit of a check, in MiB")
      ->check(CLI::Range(std::size_t(64), std::size_t(1) << 20))
      ->capture_default_str();
  add_choice(command, "--sandbox", options.confinement,
             choices_of({Confinement::kBubblewrap, Confinement::kLandlock, Confinement::kLimits}),
             "use this sandbox, or refuse to run if it does not work; by default the strongest one "
             "that works on this machine");
}

// Calls `act` at once and after every save of the file, until the program is ended.
[[noreturn]] void after_every_save(const fs::path& file, const std::function<void()>& act) {
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  std::optional<fs::file_time_type> seen;
  while (true) {
    const auto now = written_at(file);
    if (now && now != seen) {
      seen = now;
      if (terminal) fmt::print("\x1b[H\x1b[2J\x1b[3J");
      act();
      fmt::print("\nSave {} to run this again; Ctrl-C ends the program.\n", file.string());
      std::fflush(stdout);
    }
    // Looking at a file's time is cheap, and works where change notifications do not (shared
    // folders, containers).
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

}  // namespace

void LabCheckCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand(
      "check", "compiles and checks a lab's functions: the points, and the first wrong answers");
  command.footer(
      "Examples:\n"
      "  glassbox lab check ~/lab5\n"
      "  glassbox lab check ~/lab5 --html report.html\n"
      "  glassbox lab check labs/05-clipping\n\n"
      "The code runs in the same sandbox as when it is graded. The exit code is 0 for all points "
      "and 1 for fewer.");
  command
      .add_option("FOLDER", selection_.folder,
                  "a folder made by glassbox lab start, or a lab's folder in the sources")
      ->required();
  add_json_output(command, json_output_, "the report");
  add_html_output(command, html_output_, "the report as a page with pictures");
  if (!kStudentBuild) command.add_flag("--hidden", options_.hidden, "run the hidden checks too");
  add_options(command, options_, selection_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabCheckCommand::run() const {
  const ReportFiles outputs{json_output_, html_output_};
  if (const auto good = check_report_outputs(outputs.html, outputs.json); !good)
    return refuse(good.error());
  const auto folder = open_lab_folder(selection_);
  if (!folder) return refuse(folder.error());
  auto checker = LabChecker::open(*folder, options_);
  if (!checker) return refuse(checker.error());
  const auto code = check_once(**checker, outputs);
  return code ? *code : refuse(code.error());
}

void LabWatchCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command =
      *lab.add_subcommand("watch", "checks a lab, or draws a scene with it, after every save");
  command.footer(
      "Examples:\n"
      "  glassbox lab watch ~/lab5\n"
      "  glassbox lab watch ~/lab5 teapot --size 640x360 -o teapot.png --html teapot.html\n\n"
      "With SCENE it draws the scene after every save, as glassbox lab render does. A picture or "
      "page\n"
      "is replaced when the new one is complete. Ctrl-C ends the program.");
  command
      .add_option("FOLDER", selection_.folder,
                  "a folder made by glassbox lab start, or a lab's folder in the sources")
      ->required();
  command.add_option("SCENE", scene_, "draw this scene instead of running the checks");
  command
      .add_option("-o,--output", output_,
                  "with SCENE: your picture beside the reference's [SCENE.png]")
      ->type_name("FILE");
  add_html_output(command, html_output_, "the last report, or the last drawing, as a page");
  add_options(command, options_, selection_);
  add_picture_options(command, picture_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabWatchCommand::run() const {
  if (!scene_.empty()) return watch_picture();
  const ReportFiles outputs{std::nullopt, html_output_};
  if (const auto good = check_report_outputs(outputs.html, outputs.json); !good)
    return refuse(good.error());
  const auto folder = open_lab_folder(selection_);
  if (!folder) return refuse(folder.error());
  auto checker = LabChecker::open(*folder, options_);
  if (!checker) return refuse(checker.error());
  after_every_save(folder->student, [&] {
    const auto code = check_once(**checker, outputs);
    if (!code) fmt::print("{}\n", code.error().message());
  });
}

int LabWatchCommand::watch_picture() const {
  if (!selection_.lab_dir.empty())
    return refuse({"--lab-dir", "", "a lab that is given with --lab-dir cannot draw a scene",
                   "leave SCENE out"});
  const std::string output = output_.empty() ? scene_stem(scene_) + ".png" : output_;
  const LabPictureRequest request{selection_, scene_, output, picture_, {}, html_output_};
  if (const auto good = check_lab_picture(request); !good) return refuse(good.error());
  const auto folder = open_lab_folder(selection_);
  if (!folder) return refuse(folder.error());
  after_every_save(folder->student, [&] { draw_lab_picture(request); });
}

void add_check_command(CLI::App& lab, int& exit_code) {
  add_command<LabCheckCommand>(lab, exit_code);
}

void add_watch_command(CLI::App& lab, int& exit_code) {
  add_command<LabWatchCommand>(lab, exit_code);
}

}  // namespace glassbox::labs
