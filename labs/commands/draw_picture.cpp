#include "labs/commands/draw_picture.h"

#include <chrono>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/picture_output.h"
#include "cli/report/progress.h"
#include "labs/commands/drawing_report.h"
#include "labs/commands/student_stages.h"

#include <glassbox/base/printable.h>

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// The view that is drawn. For labs about stereo pairs (9 to 12) it is the view of the camera
// between the eyes, with the two eyes as `pair`.
Result<labs::DrawingInput> choose_drawing_input(const labs::Lab& lab, const Scene& scene,
                                                const PictureOptions& picture, Camera& camera) {
  constexpr int kFirstOfPairs = 9, kLastOfPairs = 12;
  labs::DrawingInput drawn{
      scene, camera, {}, with_one_sample(picture.settings), picture.camera.formulation, {}};
  if (lab.number >= kFirstOfPairs && lab.number <= kLastOfPairs) {
    const auto eyes = choose_eyes(scene, picture);
    if (!eyes) return tl::unexpected(eyes.error());
    camera = eyes->camera;
    drawn.view = eyes->centre;
    drawn.pair = eyes->eyes.pair;
    return drawn;
  }
  const auto view = choose_view(scene, picture);
  if (!view) return tl::unexpected(view.error());
  camera = view->camera;
  drawn.view = view->view;
  return drawn;
}

}  // namespace

Result<void> check_lab_picture(const LabPictureRequest& request) {
  if (const auto good = check_picture_output(request.output, {}, request.output); !good)
    return good;
  if (const auto good =
          Outputs().data(request.output).file(request.html, ".html").data(request.json).check();
      !good)
    return good;
  if (!request.picture.settings.wireframe) return {};
  return fail("--wireframe", "the labs' functions draw triangles, not lines",
              "leave --wireframe out");
}

int draw_lab_picture(const LabPictureRequest& request) {
  const auto folder = open_lab_folder(request.lab);
  if (!folder) return refuse(folder.error());
  const auto drawing = labs::drawing_of(folder->lab->number);
  if (!drawing)
    return refuse({request.lab.folder, "", "the functions of this lab draw no picture",
                   "name the folder of another lab"});
  Progress progress;
  const auto scene = load_scene_argument(request.scene, request.picture, progress);
  if (!scene) return refuse(scene.error());
  Camera camera;
  const auto drawn = choose_drawing_input(*folder->lab, *scene, request.picture, camera);
  if (!drawn) return refuse(drawn.error());

  const auto sources = labs::find_sources();
  if (!sources) return refuse(sources.error());
  StudentStages stages;
  if (const auto built = stages.build(*sources, *folder, progress); !built)
    return refuse(built.error());
  if (stages.program().program.empty()) {
    progress.done();
    fmt::print("{}", stages.program().messages);
    return kFailure;
  }

  progress.phase("drawing " + scene_title(request.scene));
  const Clock::time_point start = Clock::now();
  labs::StudentAnswers answers(stages.sandbox(), stages.program().program, request.seconds);
  const auto both = labs::draw_and_compare(*drawing, *drawn, answers);
  if (!both && answers.failure()) {
    progress.done();
    fmt::print("{}: {}\n", folder->student.string(), *answers.failure());
    const std::string which = request.lab.lab.empty() ? "" : " --lab " + request.lab.lab;
    fmt::print("No picture was drawn. Run glassbox lab check {}{} to see more.\n",
               request.lab.folder, which);
    return kFailure;
  }
  if (!both) return refuse(both.error());
  std::string words;
  for (const std::string& word : given_option_words(request.picture)) words += " " + word;
  const DrawingReport report{*folder->lab,
                             *drawing,
                             both->result,
                             request.scene,
                             words,
                             answers.printed(),
                             std::chrono::duration<double>(Clock::now() - start).count(),
                             answers.seconds()};
  progress.phase("writing " + request.output);
  const auto written = write_picture(request.output, {}, side_by_side(both->result), {});
  if (!written) return refuse(written.error());
  if (request.json) {
    if (const auto made = write_json(*request.json, drawing_json(report)); !made)
      return refuse(made.error());
  }
  if (request.html) {
    if (const auto made = write_text_result(
            *request.html,
            lab_drawing_page(report, *drawn, *both, given_option_words(request.picture)));
        !made)
      return refuse(made.error());
  }
  progress.done();
  if (request.json != "-")
    fmt::print("{}{}: yours on the left, the reference's {}; {:.1f} s\n", drawing_text(report),
               printable(request.output, kLongestMessage),
               both->result.truth ? "beside it, and then the pipeline's picture of the scene"
                                  : "on the right",
               report.seconds);
  return both->result.right() ? kSuccess : kFailure;
}

}  // namespace glassbox::labs
