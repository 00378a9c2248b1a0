#include "app/explain_command.h"

#include "app/builtin_help.h"
#include "app/stage_report.h"

#include <glassbox/render/staged.h>

namespace glassbox::app {

void ExplainCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "explain", "what every stage of a picture did, in numbers and milliseconds");
  command.footer(
      "Examples:\n"
      "  glassbox explain teapot\n"
      "  glassbox explain model.glb --size 640x480 --cull none --json -\n\n"
      "Nothing is written but the numbers. The options are those of glassbox render: the same\n"
      "words make the same picture.\n\n" +
      builtin_help());
  question_.add_to(command);
  command.callback([this, &exit_code] {
    exit_code = question_.answer(
        [this](const Scene& scene, const View& view) { return answer(scene, view); });
  });
}

Answer ExplainCommand::answer(const Scene& scene, const View& view) const {
  const Statistics statistics = render_staged(scene, view, question_.picture().settings).statistics;
  return {to_json(statistics), question_.title() + "\n\n" + stage_table(statistics)};
}

}  // namespace glassbox::app
