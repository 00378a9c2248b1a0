// glassbox stereo SCENE: reports what two eyes see of a scene, what disturbs them, and what to
// change.
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/stereo/findings.h"
#include "app/stereo/report.h"
#include "app/stereo/stereo_picture.h"
#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/builtin_help.h"
#include "cli/options/engine_options.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"

#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>

namespace glassbox::app {

class StereoCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  Result<void> check_options() const;
  std::string command_line() const;
  Result<void> write_outputs(const Scene& scene, const StereoFindings& found,
                             const StereoWords& words) const;

  std::string scene_;
  PictureOptions picture_;
  AnaglyphOptions anaglyph_;
  StereoCriteria criteria_;
  EngineOptions engine_;
  std::optional<std::string> html_output_, json_output_;
  std::vector<const CLI::Option*> options_;  // the report's options, which command_line() repeats
};

namespace {

void add_report_options(CLI::App& command, StereoCriteria& criteria) {
  const std::string group = "Limits for the pair";
  command
      .add_option_function<std::string>(
          "--budget",
          [&criteria](const std::string& text) {
            criteria.budget_percent = parse_number("--budget", text);
          },
          fmt::format(
              "parallax allowed in front of and behind the window, in per cent of the width [{:g}]",
              criteria.budget_percent))
      ->type_name("PERCENT")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--display",
          [&criteria](const std::string& text) {
            const auto [width, distance] = parse_numbers<2>("--display", text);
            criteria.display = {width, distance};
          },
          fmt::format(
              "width of the displayed picture and its distance from the viewer, in mm [{:g},{:g}]",
              criteria.display.width_mm, criteria.display.viewing_distance_mm))
      ->type_name("WIDTH,DISTANCE")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--target-rivalry",
          [&criteria](const std::string& text) {
            criteria.target_rivalry = parse_number("--target-rivalry", text);
          },
          fmt::format("largest mean rivalry of the anaglyph that is still good, from 0 (equally "
                      "bright to both eyes) to 1 [{:g}]",
                      criteria.target_rivalry))
      ->type_name("R")
      ->group(group);
}

}  // namespace

void StereoCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "stereo", "judge how comfortable a stereo pair of a scene is, and say what to change");
  command.footer(
      "Examples:\n"
      "  glassbox stereo forest\n"
      "  glassbox stereo forest --eye-separation 0.3 --window 12 --html forest.html\n"
      "  glassbox stereo room --anaglyph dubois --display 2000,3000 --json -\n\n"
      "The page needs no network and no other file. The options of the picture are those of\n"
      "glassbox render: the same options with --stereo draw the same pictures.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  add_picture_options(command, picture_);
  const std::size_t before = command.get_options().size();
  add_anaglyph_options(command, anaglyph_);
  add_report_options(command, criteria_);
  const auto all = command.get_options();
  options_.assign(all.begin() + std::ptrdiff_t(before), all.end());
  add_engine_options(command, engine_);
  const std::string outputs = "Other outputs";
  add_html_output(command, html_output_, "the report as a page, with pictures and maps")
      ->group(outputs);
  add_json_output(command, json_output_)->group(outputs);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> StereoCommand::check_options() const {
  if (picture_.eyes.seen_by) {
    return fail("--seen-by", "the report is about both eyes, so one eye cannot be chosen",
                "leave it out");
  }
  const double budget = criteria_.budget_percent;
  if (!(budget >= 0 && budget <= 100)) {
    return fail("--budget", fmt::format("{:g} is not a percentage from 0 to 100", budget),
                "give per cent of the width");
  }
  const Display& display = criteria_.display;
  if (!(display.width_mm > 0 && display.viewing_distance_mm > 0)) {
    return fail("--display",
                fmt::format("a display {:g} mm wide at a distance of {:g} mm is not possible",
                            display.width_mm, display.viewing_distance_mm),
                "give the picture's width and its distance, both above 0");
  }
  const double target = criteria_.target_rivalry;
  if (!(target >= 0 && target <= 1)) {
    return fail("--target-rivalry", fmt::format("{:g} is not between 0 and 1", target),
                "give a mean rivalry, such as 0.1");
  }
  const auto matrix = anaglyph_matrix(criteria_.method, criteria_.glasses);
  if (!matrix) return tl::unexpected(matrix.error());
  if (html_output_) {
    if (const auto legal = check_page_size(picture_.size.width, picture_.size.height); !legal) {
      return legal;
    }
  }
  return check_report_outputs(html_output_, json_output_);
}

// The command line that makes this report again.
std::string StereoCommand::command_line() const {
  std::vector<std::string> page;
  if (html_output_) page = {"--html", *html_output_};
  return shell_line(
      {{"stereo", scene_}, given_option_words(picture_), option_words(options_), page});
}

Result<void> StereoCommand::write_outputs(const Scene& scene, const StereoFindings& found,
                                          const StereoWords& words) const {
  nlohmann::ordered_json json{
      {"scene", scene_}, {"width", picture_.size.width}, {"height", picture_.size.height}};
  json.update(stereo_json(scene, found, words));
  if (html_output_) {
    const auto written = write_text_result(
        *html_output_,
        make_stereo_page(found, json, {"glassbox " GLASSBOX_VERSION, command_line()}));
    if (!written) return written;
  }
  return json_output_ ? write_json(*json_output_, json) : Result<void>();
}

int StereoCommand::run() {
  criteria_.method = anaglyph_.method.value_or(criteria_.method);
  criteria_.glasses = anaglyph_.glasses.value_or(criteria_.glasses);
  if (const auto legal = check_options(); !legal) return refuse(legal.error());
  if (const auto legal = check_engine_options(engine_); !legal) return refuse(legal.error());
  Progress progress;
  const Result<Scene> scene = load_scene_argument(scene_, picture_, progress);
  if (!scene) return refuse(scene.error());
  progress.phase("rendering " + scene_title(scene_));
  const Result<ChosenEyes> chosen = choose_eyes(*scene, picture_);
  if (!chosen) return refuse(chosen.error());
  Renderer renderer = make_renderer(*scene, picture_.settings, engine_);
  const Result<StereoFindings> found =
      find_stereo(*scene, renderer, *chosen, picture_.settings, criteria_);
  if (!found) return refuse(found.error());
  const StereoWords words{verdicts_of(*scene, *found), advise(*scene, *found)};
  progress.phase("writing the report");
  if (const auto written = write_outputs(*scene, *found, words); !written) {
    return refuse(written.error());
  }
  progress.done();
  if (json_output_ == "-") return kSuccess;
  fmt::print("{}, {} x {}\n{}", printable(scene_title(scene_), kLongPath), picture_.size.width,
             picture_.size.height, stereo_text(*found, words));
  if (html_output_) fmt::print("\n{}: open it in a browser\n", printable(*html_output_, kLongPath));
  return kSuccess;
}

void add_stereo_command(CLI::App& app, int& exit_code) {
  add_command<StereoCommand>(app, exit_code);
}

}  // namespace glassbox::app
