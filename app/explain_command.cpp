#include "app/explain_command.h"

#include <fmt/format.h>

#include "app/builtin_help.h"
#include "app/exit_codes.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/stage_report.h"

#include <glassbox/base/printable.h>
#include <glassbox/mesh/load.h>
#include <glassbox/render/staged.h>

namespace glassbox::app {

void ExplainCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "explain", "what every stage of a picture did, in numbers and milliseconds");
  command.footer(
      "Examples:\n"
      "  glassbox explain teapot\n"
      "  glassbox explain model.glb --size 640x480 --cull none --json -\n\n"
      "Nothing is written but the numbers. The options are those of glassbox render: the same "
      "words\n"
      "make the same picture.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, "a glTF, GLB or OBJ file, or the name of a built-in scene")
      ->required();
  add_picture_options(command, picture_);
  command.add_option("--json", json_output_, "the same as JSON; - is standard output")
      ->type_name("FILE|-")
      ->group("Other outputs");
  command.callback([this, &exit_code] { exit_code = run(); });
}

int ExplainCommand::run() {
  Progress progress;
  progress.phase("loading " + scene_);
  const Result<Scene> scene = load_scene(scene_, limits_);
  if (!scene) return refuse(scene.error());
  const Result<ChosenView> chosen = choose_view(*scene, picture_);
  if (!chosen) return refuse(chosen.error());
  progress.phase("rendering " + scene_);
  const Statistics statistics = render_staged(*scene, chosen->view, picture_.settings).statistics;
  progress.done();

  const auto [width, height] = picture_.size;
  if (json_output_) {
    nlohmann::ordered_json json = to_json(statistics);
    json["scene"] = scene_;
    json["size"] = {width, height};
    if (const auto written = write_json(*json_output_, json); !written) {
      return refuse(written.error());
    }
    if (*json_output_ == "-") return kSuccess;
  }
  fmt::print("{}, {} x {}\n\n{}", printable(scene_), width, height, stage_table(statistics));
  return kSuccess;
}

}  // namespace glassbox::app
