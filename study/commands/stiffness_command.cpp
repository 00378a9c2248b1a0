// glassbox study stiffness: reports the condition numbers of a scene in one view, and the error
// bounds that follow.
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/builtin_help.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "study/commands/commands.h"
#include "study/commands/stiffness/report.h"

#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>

namespace glassbox::study {

struct StiffnessReport;

class StudyStiffnessCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;
  Result<void> write_outputs(const Scene& scene, const StiffnessReport& report) const;

  std::string scene_;
  PictureOptions picture_;
  std::optional<std::string> json_output_, html_output_;
};

void StudyStiffnessCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command = *study.add_subcommand(
      "stiffness",
      "shows the condition numbers of a scene in one view, and the error bounds that follow");
  command.footer(
      "Examples:\n"
      "  glassbox study stiffness room\n"
      "  glassbox study stiffness model.glb --near 0.001 --far 1e5 --html stiff.html\n"
      "  glassbox study stiffness forest --size 640x360 --json -\n\n"
      "The options of the picture are those of glassbox render. docs/exactness.md explains the "
      "formulas.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  add_picture_options(command, picture_);
  const std::string outputs = "Other outputs";
  add_html_output(command, html_output_, "the report as a page")->group(outputs);
  add_json_output(command, json_output_)->group(outputs);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> StudyStiffnessCommand::write_outputs(const Scene& scene,
                                                  const StiffnessReport& report) const {
  if (html_output_) {
    const std::string page = stiffness_page(
        scene, report,
        shell_line({{"study", "stiffness", scene_}, report.picture, {"--html", *html_output_}}));
    const auto written = write_text(*html_output_, page);
    if (!written) return written;
  }
  return json_output_ ? write_json(*json_output_, stiffness_json(scene, report)) : Result<void>();
}

int StudyStiffnessCommand::run() const {
  if (const auto legal = check_report_outputs(html_output_, json_output_); !legal) {
    return refuse(legal.error());
  }
  print_pixel_centres_note(picture_);
  Progress progress;
  const Result<Scene> scene = load_scene_argument(scene_, picture_, progress);
  if (!scene) return refuse(scene.error());
  const Result<ChosenView> chosen = choose_view(*scene, picture_);
  if (!chosen) return refuse(chosen.error());
  progress.phase("examining " + scene_title(scene_));
  const StiffnessReport report{
      scene_, given_option_words(picture_), picture_.size.width, picture_.size.height,
      study::stiffness_of(*scene, chosen->view, picture_.settings, up_of(*scene, picture_.camera))};
  progress.done();
  if (const auto written = write_outputs(*scene, report); !written) {
    return refuse(written.error());
  }
  if (json_output_ == "-") return kSuccess;
  fmt::print("{}", stiffness_text(*scene, report));
  if (html_output_) fmt::print("\n{}: open it in a browser\n", printable(*html_output_, 1000));
  return kSuccess;
}

void add_stiffness_command(CLI::App& study, int& exit_code) {
  add_command<StudyStiffnessCommand>(study, exit_code);
}

}  // namespace glassbox::study
