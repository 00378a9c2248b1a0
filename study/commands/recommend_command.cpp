// glassbox study recommend: finds the fastest settings that draw a scene with small enough errors,
// and shows the evidence.
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/builtin_help.h"
#include "cli/options/camera_options.h"
#include "cli/options/output_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "study/commands/commands.h"
#include "study/commands/recommendation.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

class StudyRecommendCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;

  std::string scene_, budgets_;
  PictureOptions picture_;
  std::vector<const CLI::Option*> picture_words_;
  std::optional<std::string> json_output_;
};

void StudyRecommendCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command = *study.add_subcommand(
      "recommend", "finds the fastest way to draw a scene that is accurate enough");
  command.footer(
      "Examples:\n"
      "  glassbox study recommend forest --error-budget 'position<0.05px, depth<1e-4, "
      "colour<1/100'\n"
      "  glassbox study recommend model.glb --error-budget 'depth<1e-5' --json -\n\n"
      "Everything is measured on this scene, seen by this camera; docs/study.md says how.\n"
      "The exit code is 1 if a budget cannot be met.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  command
      .add_option("--error-budget", budgets_,
                  "largest errors allowed: of position in px, of depth as a fraction of the "
                  "distance, of colour as a fraction of 255 steps")
      ->type_name("LIMITS")
      ->required();
  const CLI::Option* size =
      command
          .add_option_function<std::string>(
              "--size", [this](const std::string& text) { picture_.size = parse_size(text); },
              "size of the picture [1280x720]")
          ->type_name("WxH");
  const auto before = command.get_options().size();
  add_camera_options(command, picture_.camera);
  const auto options = command.get_options();
  picture_words_.assign(options.begin() + std::ptrdiff_t(before), options.end());
  picture_words_.push_back(size);
  add_json_output(command, json_output_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

int StudyRecommendCommand::run() const {
  const auto budgets = study::parse_budgets(budgets_);
  if (!budgets) return refuse(budgets.error());
  if (const auto legal = check_report_outputs({}, json_output_); !legal)
    return refuse(legal.error());
  std::vector<std::string> words{scene_};
  for (const std::string& word : glassbox::option_words(picture_words_)) words.push_back(word);
  Progress progress;
  const Result<Scene> scene = load_scene_argument(scene_, picture_, progress);
  if (!scene) return refuse(scene.error());
  const auto found = recommend(*scene, picture_, *budgets, words, progress);
  progress.done();
  if (!found) return refuse(found.error());
  if (json_output_) {
    const auto written = write_json(*json_output_, recommendation_json(*found));
    if (!written) return refuse(written.error());
  }
  if (json_output_ != "-") fmt::print("{}", recommendation_text(*found));
  return found->meets_all() ? kSuccess : kFailure;
}

void add_recommend_command(CLI::App& study, int& exit_code) {
  add_command<StudyRecommendCommand>(study, exit_code);
}

}  // namespace glassbox::study
