#include "app/explain/explain_command.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/explain/plan_report.h"
#include "app/explain/tile_report_text.h"
#include "app/options/builtin_help.h"
#include "app/report/stage_report.h"

#include <glassbox/render/staged/staged.h>
#include <glassbox/render/tile/tile_engine.h>

namespace glassbox::app {

namespace {

// The second of two pictures: the first one waits for threads and memory.
Rendering draw_twice(const Scene& scene, const PreparedScene& prepared, const View& view,
                     const RenderSettings& settings, const TileOptions& options,
                     TileReport& report) {
  TileEngine engine(options);
  Rendering rendering;
  engine.render(scene, prepared, view, settings, rendering);
  engine.render(scene, prepared, view, settings, rendering, &report);
  return rendering;
}

}  // namespace

void ExplainCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "explain", "what a picture needs and what is left out of it, and why; what every stage did");
  command.footer(
      "Examples:\n"
      "  glassbox explain teapot\n"
      "  glassbox explain model.glb --size 640x480 --cull none --analyze\n"
      "  glassbox explain teapot --no-plan --analyze --json -\n"
      "  glassbox explain teapot --engine staged\n\n"
      "Nothing is written but what is printed. The options are those of glassbox render: the same\n"
      "words make the same picture. docs/plan.md has the proofs.\n\n" +
      builtin_help());
  question_.add_to(command);
  add_engine_options(command, engine_);
  command.add_flag("--analyze", analyze_, "draw it too: items, times and bytes of every stage")
      ->group("Engine");
  command.callback([this, &exit_code] {
    exit_code = question_.answer(
        [this](const Scene& scene, const View& view) { return answer(scene, view); });
  });
}

Result<Answer> ExplainCommand::answer(const Scene& scene, const View& view) const {
  if (const auto legal = check_engine_options(engine_); !legal) {
    return tl::unexpected(legal.error());
  }
  return engine_.engine == EngineKind::kStaged ? explain_staged(scene, view)
                                               : explain_tiles(scene, view);
}

Answer ExplainCommand::explain_staged(const Scene& scene, const View& view) const {
  const Statistics statistics = render_staged(scene, view, question_.picture().settings).statistics;
  return {to_json(statistics), question_.title() + "\n\n" +
                                   stage_table(statistics, EngineKind::kStaged) + "\n" +
                                   time_table(statistics)};
}

Answer ExplainCommand::explain_tiles(const Scene& scene, const View& view) const {
  const RenderSettings& settings = question_.picture().settings;
  const PreparedScene prepared = prepare(scene, settings.transfer);
  const DrawList list = make_draw_list(scene, prepared, view);
  const PlannedEye eye{list, view, settings};
  const Plan plan = make_plans({&eye, 1}, engine_.tile.plan).front();
  Answer answer{{{"plan", to_json(plan, eye)}},
                question_.title() + "\n\n" + plan_text(scene, plan, eye)};
  if (!analyze_) return answer;

  TileReport report;
  const Statistics statistics =
      draw_twice(scene, prepared, view, settings, engine_.tile, report).statistics;
  answer.json.update(to_json(statistics));
  answer.json["tile"] = to_json(statistics, report);
  answer.text += "\n" + engine_text(engine_) + "\n\n" + stage_table(statistics, EngineKind::kTile) +
                 "\n" + tile_text(statistics, report);
  return answer;
}

}  // namespace glassbox::app
