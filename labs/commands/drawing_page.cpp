#include "labs/commands/drawing_page.h"

#include <utility>

#include "cli/options/scene_input.h"
#include "inspect/page.h"

namespace glassbox::labs {

namespace {

using Json = nlohmann::ordered_json;

Json wrong_json(const labs::WrongNumber& n) {
  return {{"element", n.element}, {"yours", n.yours}, {"reference", n.reference},
          {"bound", n.bound},     {"unit", n.unit},   {"explanation", n.explanation}};
}

Json records_json(const labs::DrawingResult& result) {
  Json records = Json::array();
  for (const labs::KeptRecord& each : result.kept) {
    records.push_back({{"stage", each.stage},
                       {"record", each.record},
                       {"triangle", each.triangle == kNone ? Json(nullptr) : Json(each.triangle)},
                       {"yours", each.yours},
                       {"reference", each.reference},
                       {"wrong", each.wrong ? wrong_json(*each.wrong) : Json(nullptr)}});
  }
  return records;
}

// The run for the picture under the page's overlays: the colours as drawn, without the student's
// change of the finished picture (`finish`).
labs::StandIn as_shown(labs::StandIn run) {
  run.finish = nullptr;
  if (run.settings.show != Show::kNormal && run.settings.show != Show::kUv)
    run.settings.show = Show::kColor;
  return run;
}

}  // namespace

Result<std::string> lab_drawing_page(const DrawingReport& report, const labs::Drawn& drawn,
                                     const labs::DrawnBoth& both,
                                     const std::vector<std::string>& words) {
  const labs::StandIn yours = as_shown(both.yours), reference = as_shown(both.reference);
  // If the student's code changes the finished picture, the page shows the changed picture in
  // addition to the run's.
  const bool other = both.yours.finish != nullptr;
  const labs::DrawingResult& result = both.result;
  const Image<Rgba8> reference_picture =
      other ? result.reference : std::move(reference.render().buffers.color);
  Json student = drawing_json(report);
  student["records"] = records_json(both.result);

  inspect::InspectOptions options;
  options.scene_name = scene_title(report.scene) + ", lab " + std::to_string(report.lab.number);
  options.words = words;
  options.program = "glassbox " GLASSBOX_VERSION;
  options.command = "glassbox lab render FOLDER " + report.scene + report.picture_words;
  options.stages = yours.stages.get();
  options.student = student.dump(-1, ' ', false, Json::error_handler_t::replace);
  options.reference = &reference_picture;
  if (other) options.made = &result.yours;
  if (result.truth) options.truth = &*result.truth;
  const auto page =
      inspect::make_inspect_page(yours.scene, drawn.camera, yours.view, yours.settings, options);
  if (!page) return tl::unexpected(page.error());
  return page->html;
}

}  // namespace glassbox::labs
