#include "app/explain/explain_command.h"

#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/explain/pair_report.h"
#include "app/explain/planning_engine.h"
#include "app/explain/tile_report_text.h"
#include "cli/options/builtin_help.h"
#include "cli/report/stage_report.h"

#include <glassbox/render/renderer.h>

namespace glassbox::app {

void ExplainCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "explain", "what a picture needs and what is left out of it, and why; what every stage did");
  command.footer(
      "Examples:\n"
      "  glassbox explain teapot\n"
      "  glassbox explain model.glb --size 640x480 --cull none --analyze\n"
      "  glassbox explain teapot --no-plan --analyze --json -\n"
      "  glassbox explain teapot --engine staged\n"
      "  glassbox explain forest --stereo anaglyph --analyze\n\n"
      "Nothing is written but what is printed. The options are those of glassbox render: the same\n"
      "words make the same picture. docs/plan.md has the proofs.\n\n" +
      builtin_help());
  question_.add_to(command);
  add_stereo_picture_options(command, stereo_);
  add_engine_options(command, engine_);
  command.add_flag("--analyze", analyze_, "draw it too: items, times and bytes of every stage")
      ->group("Engine");
  command.callback([this, &exit_code] {
    exit_code = question_.answer_of_scene([this](const Scene& scene) { return answer(scene); });
  });
}

Result<Answer> ExplainCommand::answer(const Scene& scene) const {
  if (const auto legal = check_engine_options(engine_); !legal) {
    return tl::unexpected(legal.error());
  }
  if (const auto legal = check_stereo_picture(question_.picture(), stereo_); !legal) {
    return tl::unexpected(legal.error());
  }
  if (stereo_.second_eye) {
    return fail("--second-eye", "an eye that is warped has no stages",
                "leave it out, or see render --report");
  }
  if (stereo_.form.wanted) return explain_pair(scene);
  const Result<ChosenView> chosen = choose_view(scene, question_.picture());
  if (!chosen) return tl::unexpected(chosen.error());
  return engine_.engine == EngineKind::kStaged ? explain_staged(scene, chosen->view)
                                               : explain_tiles(scene, chosen->view);
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
  Rendering drawn;
  const EyePicture eye{view, settings, drawn.buffers, drawn.buffers.color, drawn.statistics};
  const PictureJob job{scene, prepared, {&eye, 1}};
  PlannedPictures planned;
  if (analyze_) {
    PlanningEngine(engine_.tile, planned).draw(job);
  } else {
    plan_pictures(job, engine_.tile, planned);
  }
  Answer answer{{{"plan", planned.json.front()}},
                question_.title() + "\n\n" + planned.texts.front()};
  if (!analyze_) return answer;
  answer.json.update(to_json(drawn.statistics));
  answer.json["tile"] = to_json(drawn.statistics, planned.report);
  answer.text += "\n" + engine_text(engine_) + "\n\n" +
                 stage_table(drawn.statistics, EngineKind::kTile) + "\n" +
                 tile_text(drawn.statistics, planned.report);
  return answer;
}

// Plans and draws the pictures of `render --stereo` with the same functions as that command.
Result<Answer> ExplainCommand::explain_pair(const Scene& scene) const {
  const RenderSettings& settings = question_.picture().settings;
  const Result<ChosenEyes> chosen = choose_eyes(scene, question_.picture());
  if (!chosen) return tl::unexpected(chosen.error());
  PlannedPictures planned;
  std::unique_ptr<Engine> engine;
  if (engine_.engine == EngineKind::kTile) {
    engine = std::make_unique<PlanningEngine>(engine_.tile, planned);
  } else {
    engine = make_engine(EngineKind::kStaged);
  }
  Renderer renderer(scene, settings.transfer, std::move(engine));
  views::SecondEye second;
  const Result<StereoPicture> drawn =
      render_stereo_picture(renderer, scene, *chosen, settings, stereo_, second);
  if (!drawn) return tl::unexpected(drawn.error());

  const StereoRendering& both = drawn->rendering;
  const PairReport pair{both, planned, analyze_ || planned.texts.empty()};
  Answer answer{{{"stereo", eyes_json(*chosen, both)}},
                question_.title() + "\n" + eyes_text(*chosen, both) + "\n"};
  answer.json.update(pair_json(pair));
  if (!pair.is_planned() && engine_.engine == EngineKind::kTile) {
    answer.text += "--stereo-cull centre: drawn by the staged engine, which has no plan\n\n";
  } else if (analyze_) {
    answer.text += engine_text(engine_) + "\n\n";
  }
  answer.text += pair_text(pair);
  return answer;
}

}  // namespace glassbox::app
