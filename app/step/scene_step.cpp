#include "app/step/scene_step.h"

#include <iostream>

#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/options/scene_input.h"
#include "app/report/exit_codes.h"
#include "app/report/output.h"
#include "app/report/progress.h"
#include "app/step/restage.h"
#include "app/step/stepper.h"
#include "app/trace/json.h"

#include <glassbox/base/printable.h>

namespace glassbox::app {

namespace {

bool on_a_terminal() {
  return isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
}

std::string all_stages(const std::vector<StageText>& stages) {
  std::string text;
  for (const StageText& stage : stages) text += "\n" + stage.text;
  return text;
}

}  // namespace

void SceneStep::add_to(CLI::App& command) {
  const std::string group = "A triangle of a scene";
  command.add_option("SCENE", scene_, kSceneHelp);
  CLI::Option* triangle =
      command.add_option("--triangle", triangle_, "its number in the scene, counted from 0")
          ->type_name("N")
          ->group(group);
  command
      .add_option_function<std::string>(
          "--pick",
          [this](const std::string& text) {
            const auto [x, y] = parse_pixel("--pick", text);
            pick_ = {{x, y}};
          },
          "the triangle that is seen in this pixel, and its fragment there")
      ->type_name("X,Y")
      ->group(group)
      ->excludes(triangle);
  command.add_option("--vertex", vertex_, "only this corner of it: 0, 1 or 2")
      ->type_name("K")
      ->check(CLI::Range(0, 2))
      ->group(group);
  command
      .add_flag("--interactive", interactive_,
                "stage by stage, even where the input is no terminal")
      ->group(group);
  add_picture_options(command, picture_);
}

Result<StepTarget> SceneStep::find_target(const Scene& scene) const {
  StepTarget target;
  target.vertex = vertex_;
  target.pixel = pick_;
  if (pick_) {
    const auto [x, y] = *pick_;
    if (const auto legal = check_pixel("--pick", {x, y}, picture_.size); !legal) {
      return tl::unexpected(legal.error());
    }
    const auto picked = pick(scene, picture_, x, y);
    if (!picked) return tl::unexpected(picked.error());
    target.triangle = *picked;
    return target;
  }
  if (!triangle_) {
    return fail("", "no triangle is named",
                "give --triangle N, or --pick X,Y for what a pixel shows");
  }
  if (const auto legal = check_triangle("--triangle", scene, *triangle_); !legal) {
    return tl::unexpected(legal.error());
  }
  target.triangle = *triangle_;
  return target;
}

std::string SceneStep::heading(const SteppedTriangle& stepped) const {
  return fmt::format("triangle {} of {}, {} x {}\n", stepped.place.number,
                     printable(scene_title(scene_)), picture_.size.width, picture_.size.height);
}

int SceneStep::run(bool bits, const std::optional<std::string>& json_output) {
  if (interactive_ && scene_ == "-") {
    return refuse({"", "--interactive", "standard input is the scene",
                   "leave it out, or name the scene's file"});
  }
  tell_of_centres(picture_);
  Progress progress;
  progress.phase("loading " + scene_title(scene_));
  const Result<Scene> scene = load_asked_scene(scene_, limits_);
  if (!scene) return refuse(scene.error());
  for (const std::string& warning : scene->warnings) progress.say("warning: " + warning);
  progress.phase("rendering " + scene_title(scene_));
  const Result<StepTarget> target = find_target(*scene);
  if (!target) return refuse(target.error());
  const Result<SteppedTriangle> stepped = step_through(*scene, picture_, target->triangle);
  if (!stepped) return refuse(stepped.error());
  progress.done();

  if (json_output) {
    nlohmann::ordered_json json = to_json(*scene, stepped->trace);
    json["scene"] = scene_;
    if (const auto written = write_json(*json_output, json); !written)
      return refuse(written.error());
    if (*json_output == "-") return kSuccess;
  }
  Staged staged{{words_given(picture_), *target}, stage_texts(*scene, *stepped, *target, bits)};
  fmt::print("{}", heading(*stepped));
  if (!interactive_ && !(on_a_terminal() && !json_output)) {
    fmt::print("{}", all_stages(staged.stages));
    return kSuccess;
  }
  const OptionWords options = restage_options();
  const auto lines = on_a_terminal()
                         ? terminal_lines([&options](const std::vector<std::string>& words) {
                             return step_candidates(words, options);
                           })
                         : lines_of(std::cin);
  step_by_hand(*lines, std::move(staged),
               [&](const StepChoice& choice, const std::vector<std::string>& more) {
                 return restage(*scene, bits, choice, more);
               });
  return kSuccess;
}

}  // namespace glassbox::app
