// glassbox explain SCENE: which stages the tile engine's plan leaves out and why; with --analyze,
// also what went into every stage, what came out, and how long it took.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "app/commands.h"
#include "app/explain/plan_report.h"
#include "app/explain/tile_report_text.h"
#include "app/stereo/stereo_picture.h"
#include "cli/options/add_command.h"
#include "cli/options/builtin_help.h"
#include "cli/options/engine_options.h"
#include "cli/options/picture_question.h"
#include "cli/report/stage_report.h"

#include <glassbox/render/renderer.h>

namespace glassbox::app {

// The data for the report of `explain --stereo` on both eyes' pictures.
struct PairReport {
  const StereoRendering& rendering;
  // Empty if the staged engine has drawn the pictures: it makes no plan.
  const PlannedPictures& planned;
  bool counted = false;  // whether the stages' counts are wanted

  bool is_planned() const { return !planned.texts.empty(); }
};

namespace {

struct ReportedEye {
  const char* key;
  const char* heading;
  const Statistics& statistics;
};

std::vector<ReportedEye> eyes_of(const StereoRendering& both) {
  if (both.passes == 1) return {{"both", "both eyes", both.left_statistics}};
  return {{"left", "the left eye", both.left_statistics},
          {"right", "the right eye", both.right_statistics}};
}

std::string plans_text(const std::vector<ReportedEye>& eyes,
                       const std::vector<std::string>& plans) {
  const bool same = std::ranges::all_of(plans, [&](const auto& p) { return p == plans.front(); });
  if (same) return "both eyes\n\n" + plans.front() + "\n";
  std::string text;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    text += eyes[i].heading + std::string("\n\n") + plans[i] + "\n";
  }
  return text;
}

}  // namespace

// The report as text. If both eyes have the same plan, the plan is printed only once.
std::string pair_text(const PairReport& pair) {
  const std::vector<ReportedEye> eyes = eyes_of(pair.rendering);
  std::string text;
  if (pair.is_planned()) text += plans_text(eyes, pair.planned.texts);
  if (!pair.counted) return text;
  const EngineKind engine = pair.is_planned() ? EngineKind::kTile : EngineKind::kStaged;
  for (const ReportedEye& eye : eyes) {
    text += eye.heading + std::string("\n") + stage_table(eye.statistics, engine) + "\n";
  }
  // Work shared by both eyes is counted and timed with the first eye.
  const Statistics& first = eyes.front().statistics;
  return text + (pair.is_planned() ? tile_text(first, pair.planned.report) : time_table(first));
}

// The report as JSON. The keys are "left" and "right", or "both" where both eyes have one picture.
nlohmann::ordered_json pair_json(const PairReport& pair) {
  const std::vector<ReportedEye> eyes = eyes_of(pair.rendering);
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    nlohmann::ordered_json& of_eye = json[eyes[i].key];
    if (pair.is_planned()) of_eye["plan"] = pair.planned.json[i];
    if (pair.counted) of_eye.update(to_json(eyes[i].statistics));
  }
  if (pair.counted && pair.is_planned()) {
    json["tile"] = to_json(eyes.front().statistics, pair.planned.report);
  }
  return json;
}

class ExplainCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  Result<Answer> answer(const Scene& scene) const;
  Answer explain_staged(const Scene& scene, const View& view) const;
  Answer explain_tiles(const Scene& scene, const View& view) const;
  Result<Answer> explain_pair(const Scene& scene) const;

  PictureQuestion question_;
  StereoPictureOptions stereo_;
  EngineOptions engine_;
  bool analyze_ = false;
};

void ExplainCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "explain",
      "say which steps a picture needs, which are left out and why, and what every stage did");
  command.footer(
      "Examples:\n"
      "  glassbox explain teapot\n"
      "  glassbox explain model.glb --size 640x480 --cull none --analyze\n"
      "  glassbox explain teapot --no-plan --analyze --json -\n"
      "  glassbox explain teapot --engine staged\n"
      "  glassbox explain forest --stereo anaglyph --analyze\n\n"
      "No file is written. The options are those of glassbox render: the same options make the "
      "same\n"
      "picture. docs/plan.md has the proofs.\n\n" +
      builtin_help());
  question_.add_to(command);
  add_stereo_picture_options(command, stereo_);
  add_engine_options(command, engine_);
  command
      .add_flag("--analyze", analyze_,
                "draw the picture too, and print items, times and bytes of every stage")
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
    return fail("--second-eye",
                "a warped eye is not drawn by the pipeline, so there are no stages to explain",
                "leave this option out, or use glassbox render --report");
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
  const PreparedScene prepared = prepare_scene(scene, settings.transfer);
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
    answer.text += "With --stereo-cull centre the staged engine draws, which has no plan.\n\n";
  } else if (analyze_) {
    answer.text += engine_text(engine_) + "\n\n";
  }
  answer.text += pair_text(pair);
  return answer;
}

void add_explain_command(CLI::App& app, int& exit_code) {
  add_command<ExplainCommand>(app, exit_code);
}

}  // namespace glassbox::app
