// glassbox lab stiff: shows in which extreme cases a student's functions fail, next to the
// reference.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "labs/commands/commands.h"
#include "labs/commands/find_lab.h"
#include "labs/commands/student_stages.h"
#include "labs/drawing/stage_program.h"
#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "study/extremes/run_case.h"

#include <glassbox/base/error.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox::labs {

// Tests the extreme cases of a lab: draws each with a student's functions in the pipeline.
struct StiffCase {
  const study::ExtremeCase* extreme_case = nullptr;
  // The verdicts of the judge that each extreme case has: `yours` with the student's functions in
  // the pipeline, `reference` with the reference's functions, `naive` for naive code. `yours` and
  // `reference` are absent if the case does not show in a picture that the lab draws.
  std::optional<study::Outcome> yours, reference;
  study::Outcome naive;
  std::string failure;  // how the student's code ended; empty if it ended normally
  // Whether the reference fails too, so that no function that keeps to student.h can be expected to
  // pass.
  bool out_of_reach() const { return yours && failure.empty() && !reference->passes(); }
  bool gives_up() const {
    return yours && (!failure.empty() || (!yours->passes() && reference->passes()));
  }
};

namespace {

// A camera that gives the view's matrices.
Camera camera_of(const View& view) {
  Camera camera;
  camera.world_from_eye = inverse_rigid(view.eye_from_world);
  const double scale = view.clip_from_eye.at(1, 1);
  const auto far = std::isinf(view.far) ? std::nullopt : std::optional(view.far);
  if (view.perspective) {
    camera.lens = PerspectiveLens{2 * arctan2(1, scale), view.near, far};
  } else {
    camera.lens = OrthographicLens{1 / scale, view.near, view.far};
  }
  return camera;
}

// Whether a lab's projection function can make the view's projection: the window must be centred on
// the gaze, with the picture's own aspect ratio.
bool has_plain_lens(const View& view) {
  const auto& m = view.clip_from_eye;
  const double aspect = double(view.viewport.width()) / double(view.viewport.height());
  return m.at(0, 2) == 0 && m.at(1, 2) == 0 && m.at(0, 3) == 0 && m.at(1, 3) == 0 &&
         std::abs(m.at(1, 1) - aspect * m.at(0, 0)) <= 1e-12 * std::abs(m.at(1, 1));
}

struct DrawingOutcome {
  bool not_this_lab = false;  // a pair, several samples, or a view that the lab has no function for
  std::string failure;
};

// Makes the lab's functions an engine that the catalogue of extreme cases can test. `answer_source`
// gives the functions' results: the student's or the reference's.
study::TestedEngine tested_engine_of(const labs::Lab& lab, const labs::LabDrawing& drawing,
                                     labs::AnswerSource& answer_source, DrawingOutcome& outcome) {
  constexpr int kProjection = 4, kStereo = 9;
  const auto draw = [&](const Scene& scene, const View& view, const RenderSettings& settings) {
    const bool can = lab.number != kStereo && samples_drawn(settings) == 1 && !settings.wireframe &&
                     (lab.number != kProjection || has_plain_lens(view));
    const Camera camera = camera_of(view);
    const labs::DrawingInput drawn{scene, camera, view, settings, {}, {}};
    if (can) {
      const auto made = drawing.draw(drawn, answer_source);
      if (made) return made->render();
      if (outcome.failure.empty()) outcome.failure = made.error().message();
    } else {
      outcome.not_this_lab = true;
    }
    return render_staged(scene, view,
                         settings);  // the judge needs some picture; its verdict is not used
  };
  const auto renderer = [&](const Scene& scene, Transfer transfer) {
    outcome.not_this_lab = true;
    return Renderer(scene, transfer, EngineKind::kStaged, {});
  };
  return {"lab", draw, renderer};
}

class ReferenceAnswers : public labs::AnswerSource {
public:
  Result<std::vector<labs::Numbers>> ask(const labs::DrawnStage& stage,
                                         std::span<const labs::Question> questions) override {
    std::vector<labs::Numbers> answers;
    for (const labs::Question& question : questions) {
      labs::RecordReader in(question.numbers.data(), question.numbers.size());
      answers.push_back(stage.reference(in));
    }
    return answers;
  }
};

}  // namespace

// The cases that the lab's handout names under "Stiff cases", sorted by code.
Result<std::vector<const study::ExtremeCase*>> cases_of_lab(const labs::Sources& sources,
                                                            const labs::Lab& lab) {
  const auto handout = labs::read_text_file(sources.labs / lab.folder / "handout.md");
  if (!handout) return tl::unexpected(handout.error());
  std::vector<const study::ExtremeCase*> cases;
  const std::size_t section = handout->find("## Stiff cases");
  for (std::size_t at = section; at != std::string::npos && at < handout->size();) {
    at = handout->find("C-", at);
    if (at == std::string::npos) break;
    const std::size_t end = handout->find_first_not_of("0123456789", at + 2);
    const study::ExtremeCase* found = study::find_case(handout->substr(at, end - at));
    if (found != nullptr && std::find(cases.begin(), cases.end(), found) == cases.end())
      cases.push_back(found);
    at += 2;
  }
  std::sort(cases.begin(), cases.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  return cases;
}

StiffCase run_case(const study::ExtremeCase& extreme, const labs::Lab& lab,
                   const labs::LabDrawing& drawing, const labs::grading::Sandbox& sandbox,
                   const labs::StageProgram& program, double seconds) {
  StiffCase result{&extreme, {}, {}, {}, {}};
  if (!extreme.drawn) return result;
  ReferenceAnswers reference;
  DrawingOutcome with_reference, with_yours;
  const study::Outcome right =
      extreme.drawn(tested_engine_of(lab, drawing, reference, with_reference));
  if (with_reference.not_this_lab || !with_reference.failure.empty()) return result;
  labs::StudentAnswers student(sandbox, program.program, seconds);
  const study::Outcome yours = extreme.drawn(tested_engine_of(lab, drawing, student, with_yours));
  result.reference = right;
  result.yours = yours;
  result.naive = extreme.naive.measure_error();
  result.failure = student.failure().value_or(with_yours.failure);
  return result;
}

class LabStiffCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  LabSelection selection_;
  std::optional<std::string> json_output_;
  double seconds_ = 10;
};

namespace {

using Json = nlohmann::ordered_json;

std::string number_text(const study::Outcome& outcome) {
  return fmt::format("{:.3g}{}", outcome.error, outcome.passes() ? "" : " !");
}

std::string report_text(const labs::Lab& lab, const std::vector<StiffCase>& cases) {
  std::size_t width = 0;
  for (const StiffCase& each : cases)
    if (each.yours) width = std::max(width, each.extreme_case->name.size());
  std::string text =
      fmt::format("Lab {}: {}\n\n  {:<6}{:<{}}{:>12}{:>12}{:>12}{:>10}  {}\n", lab.number,
                  lab.title, "case", "", width, "yours", "reference", "naive", "bound", "unit");
  std::string not_drawn;
  for (const StiffCase& each : cases) {
    const study::ExtremeCase& extreme = *each.extreme_case;
    if (!each.yours) {
      not_drawn += (not_drawn.empty() ? "" : ", ") + extreme.id;
      continue;
    }
    text += fmt::format("  {:<6}{:<{}}{:>12}{:>12}{:>12}{:>10.3g}  {}\n", extreme.id, extreme.name,
                        width, each.failure.empty() ? number_text(*each.yours) : "ended !",
                        number_text(*each.reference), number_text(each.naive), each.yours->bound,
                        extreme.unit);
  }
  text +=
      "\nA ! marks an error above its bound. Naive code is measured alone, without a picture.\n";
  for (const StiffCase& each : cases) {
    if (each.out_of_reach())
      text += fmt::format(
          "{}: the reference's error is above the bound too, because student.h asks for less "
          "accuracy.\n",
          each.extreme_case->id);
    if (!each.gives_up()) continue;
    text += fmt::format("{}: {}\n", each.extreme_case->id,
                        each.failure.empty() ? each.yours->summary : each.failure);
    text += fmt::format("  glassbox study extremes --case {}\n", each.extreme_case->id);
  }
  if (!not_drawn.empty())
    text += fmt::format(
        "These cases were not tried with your functions, because no picture of this lab shows "
        "them: {}.\n",
        not_drawn);
  return text;
}

Json outcome_json(const study::Outcome& outcome) {
  return {{"error", outcome.error}, {"bound", outcome.bound}, {"seen", outcome.summary}};
}

Json report_json(const labs::Lab& lab, const std::vector<StiffCase>& cases) {
  Json json{{"lab", lab.folder}, {"cases", Json::array()}};
  for (const StiffCase& each : cases) {
    Json one{{"id", each.extreme_case->id},
             {"name", each.extreme_case->name},
             {"unit", each.extreme_case->unit}};
    if (each.yours) {
      one["yours"] = outcome_json(*each.yours);
      one["reference"] = outcome_json(*each.reference);
      one["naive"] = outcome_json(each.naive);
      one["gives_up"] = each.gives_up();
      if (!each.failure.empty()) one["ended"] = each.failure;
    }
    json["cases"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

void LabStiffCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand(
      "stiff", "draws a lab's extreme cases with your functions, and says which cases they fail");
  command.footer(
      "Examples:\n"
      "  glassbox lab stiff ~/lab6\n\n"
      "Each case that the handout names and that a picture can show is drawn with your functions "
      "in the\n"
      "pipeline, and judged as glassbox study extremes judges it. The exit code is 0 if your "
      "functions\n"
      "are within the bound in every case in which the reference's functions are.");
  command
      .add_option("FOLDER", selection_.folder,
                  "a folder made by glassbox lab start, or a lab's folder in the sources")
      ->required();
  add_lab_name(command, selection_.lab);
  add_json_output(command, json_output_, "the report");
  command
      .add_option("--time-limit", seconds_,
                  "time limit of a stage that runs your functions, in seconds")
      ->check(number_between(0.1, 3600))
      ->capture_default_str();
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabStiffCommand::run() const {
  if (const auto good = check_report_outputs({}, json_output_); !good) return refuse(good.error());
  const auto folder = open_lab_folder(selection_);
  if (!folder) return refuse(folder.error());
  const auto drawing = labs::drawing_of(folder->lab->number);
  const auto sources = labs::find_sources();
  if (!sources) return refuse(sources.error());
  const auto cases = cases_of_lab(*sources, *folder->lab);
  if (!cases) return refuse(cases.error());
  if (!drawing || cases->empty())
    return refuse({selection_.folder, "", "this lab has no extreme cases to draw",
                   "name the folder of a lab that has extreme cases (docs/labs.md)"});
  Progress progress;
  StudentStages stages;
  if (const auto built = stages.build(*sources, *folder, progress); !built)
    return refuse(built.error());
  if (stages.program().program.empty()) {
    progress.done();
    fmt::print("{}", stages.program().messages);
    return kFailure;
  }
  std::vector<StiffCase> results;
  for (const study::ExtremeCase* each : *cases) {
    progress.phase("drawing " + each->id);
    results.push_back(
        run_case(*each, *folder->lab, *drawing, stages.sandbox(), stages.program(), seconds_));
  }
  progress.done();
  if (std::none_of(results.begin(), results.end(),
                   [](const auto& c) { return c.yours.has_value(); }))
    return refuse({selection_.folder, "", "no picture of this lab shows one of its extreme cases",
                   fmt::format("look at one of them by itself: glassbox study extremes --case {}",
                               results.front().extreme_case->id)});
  if (json_output_) {
    if (const auto made = write_json(*json_output_, report_json(*folder->lab, results)); !made)
      return refuse(made.error());
  }
  if (json_output_ != "-") fmt::print("{}", report_text(*folder->lab, results));
  return std::any_of(results.begin(), results.end(), [](const auto& c) { return c.gives_up(); })
             ? kFailure
             : kSuccess;
}

void add_stiff_command(CLI::App& lab, int& exit_code) {
  add_command<LabStiffCommand>(lab, exit_code);
}

}  // namespace glassbox::labs
