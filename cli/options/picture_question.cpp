#include "cli/options/picture_question.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/output_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"

#include <glassbox/base/printable.h>

namespace glassbox {

void PictureQuestion::add_to(CLI::App& command) {
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  add_picture_options(command, picture_);
  add_json_output(command, json_output_)->group("Other outputs");
}

void PictureQuestion::add_check(CLI::App& command, const std::string& help) {
  command.add_flag("--check", check_, help)->group("Other outputs");
}

std::string PictureQuestion::title() const {
  return fmt::format("{}, {} x {}", printable(scene_title(scene_), kLongPath), picture_.size.width,
                     picture_.size.height);
}

int PictureQuestion::answer(const AnswerFunction& ask) const {
  return answer_of_scene([&](const Scene& scene) -> Result<Answer> {
    const Result<ChosenView> chosen = choose_view(scene, picture_);
    if (!chosen) return tl::unexpected(chosen.error());
    return ask(scene, chosen->view);
  });
}

int PictureQuestion::answer_of_scene(const SceneAnswerFunction& ask) const {
  if (const auto legal = check_report_outputs({}, json_output_); !legal)
    return refuse(legal.error());
  Progress progress;
  const Result<Scene> scene = load_scene_argument(scene_, picture_, progress);
  if (!scene) return refuse(scene.error());
  progress.phase("rendering " + scene_title(scene_));
  const Result<Answer> found = ask(*scene);
  if (!found) return refuse(found.error());
  progress.done();

  if (json_output_) {
    nlohmann::ordered_json json{
        {"scene", scene_}, {"width", picture_.size.width}, {"height", picture_.size.height}};
    json.update(found->json);
    const auto written = write_json(*json_output_, json);
    if (!written) return refuse(written.error());
  }
  if (json_output_ != "-") fmt::print("{}", found->text);
  return check_ && !found->passes ? kFailure : kSuccess;
}

}  // namespace glassbox
