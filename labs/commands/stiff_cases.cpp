#include "labs/commands/stiff_cases.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox::labs {

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

// Whether a lab's projection function can make the view's projection: a window centred on the gaze,
// with the picture's own aspect.
bool has_plain_lens(const View& view) {
  const auto& m = view.clip_from_eye;
  const double aspect = double(view.viewport.width()) / double(view.viewport.height());
  return m.at(0, 2) == 0 && m.at(1, 2) == 0 && m.at(0, 3) == 0 && m.at(1, 3) == 0 &&
         std::abs(m.at(1, 1) - aspect * m.at(0, 0)) <= 1e-12 * std::abs(m.at(1, 1));
}

struct Drawing {
  bool not_this_lab = false;  // a pair, several samples, or a view that the lab has no function for
  std::string failure;
};

// Makes the lab's functions a drawer for the catalogue of extreme cases. `answering` gives their
// results: the student's or the reference's.
study::Drawer drawer_of(const labs::Lab& lab, const labs::LabDrawing& drawing,
                        labs::Answering& answering, Drawing& went) {
  constexpr int kProjection = 4, kStereo = 9;
  const auto draw = [&](const Scene& scene, const View& view, const RenderSettings& settings) {
    const bool can = lab.number != kStereo && samples_drawn(settings) == 1 && !settings.wireframe &&
                     (lab.number != kProjection || has_plain_lens(view));
    const Camera camera = camera_of(view);
    const labs::Drawn drawn{scene, camera, view, settings, {}, {}};
    if (can) {
      const auto made = drawing.draw(drawn, answering);
      if (made) return made->render();
      if (went.failure.empty()) went.failure = made.error().message();
    } else {
      went.not_this_lab = true;
    }
    return render_staged(scene, view,
                         settings);  // the judge needs some picture; its verdict is not used
  };
  const auto renderer = [&](const Scene& scene, Transfer transfer) {
    went.not_this_lab = true;
    return Renderer(scene, transfer, EngineKind::kStaged, {});
  };
  return {"lab", draw, renderer};
}

class ReferenceAnswers : public labs::Answering {
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

StiffCase put_case(const study::ExtremeCase& extreme, const labs::Lab& lab,
                   const labs::LabDrawing& drawing, const labs::grading::Sandbox& sandbox,
                   const labs::StageProgram& program, double seconds) {
  StiffCase put{&extreme, {}, {}, {}, {}};
  if (!extreme.drawn) return put;
  ReferenceAnswers reference;
  Drawing with_reference, with_yours;
  const study::Outcome right = extreme.drawn(drawer_of(lab, drawing, reference, with_reference));
  if (with_reference.not_this_lab || !with_reference.failure.empty()) return put;
  labs::StudentAnswers student(sandbox, program.program, seconds);
  const study::Outcome yours = extreme.drawn(drawer_of(lab, drawing, student, with_yours));
  put.reference = right;
  put.yours = yours;
  put.naive = extreme.naive.judged();
  put.broke = student.broke().value_or(with_yours.failure);
  return put;
}

}  // namespace glassbox::labs
