#include <nlohmann/json.hpp>

#include "cli/report/shell_line.h"
#include "study/commands/scene/curve_report.h"
#include "study/experiment/results_json.h"
#include "views/commands/eye_error_json.h"

namespace glassbox::study {

namespace {

using Json = nlohmann::ordered_json;

std::string scene_of(const CurveReport& report, const study::RenderVariant& variant) {
  if (!variant.level) return report.scene;
  return report.scene.substr(0, report.scene.find(':')) + ":" + std::to_string(*variant.level);
}

Json point_json(const CurveReport& report, const CurvePoint& point) {
  Json json{{"name", name_of(point.variant)},
            {"knob", name_of(point.variant.knob)},
            {"command", command_of(report, point)},
            {"picture", point.picture},
            {"rms", point.error.rms},
            {"largest", point.error.largest},
            {"wrong", point.error.wrong},
            {"flip", point.error.flip},
            {"depth_error", study::number_json(point.depth_error)},
            {"threads", point.variant.threads()},
            {"ns", point.ns.median},
            {"ns_quartiles", {point.ns.lower, point.ns.upper}},
            {"ns_octiles", {point.ns.first_octile, point.ns.last_octile}},
            {"disturbed", point.disturbed},
            {"standing", nullptr}};
  if (point.standing) json["standing"] = name_of(*point.standing);
  return json;
}

Json second_eyes_json(const SecondEyes& eyes) {
  if (!eyes.left_out.empty()) return {{"left_out", eyes.left_out}};
  const views::SecondEyeError& one = eyes.warped.front();
  Json json{{"separation", 2 * eyes.pair.half_separation},
            {"window", study::number_json(eyes.pair.window)},
            {"pixels", one.pixels},
            {"one_eye_ms", one.one_eye_ms},
            {"both_drawn_ms", one.both_drawn_ms},
            {"left_in_its_place", eye_error_json(one.left)},
            {"warped", Json::array()}};
  for (const views::SecondEyeError& eye : eyes.warped) {
    Json each = eye_error_json(eye.warped);
    each["layers"] = eye.layers;
    each["holes"] = eye.holes;
    each["both_ms"] = eye.both_warped_ms;
    json["warped"].push_back(std::move(each));
  }
  return json;
}

}  // namespace

std::string command_of(const CurveReport& report, const CurvePoint& point) {
  if (report.scene == "-") return {};  // a scene from a pipe cannot be read again
  std::vector<std::string> own = point.variant.options;
  if (point.variant.engine == EngineKind::kTile && point.variant.threads() == 1)
    own.insert(own.end(), {"--threads", "1"});
  return shell_line({{"render", scene_of(report, point.variant)}, report.words, own});
}

Json curve_json(const CurveReport& report) {
  const study::Curve& curve = report.curve;
  Json json{{"scene", report.scene},
            {"width", report.size.width},
            {"height", report.size.height},
            {"command", report.command},
            {"version", report.origin.version},
            {"machine", report.origin.machine},
            {"compiler", report.origin.compiler},
            {"flags", report.origin.flags},
            {"repetitions", curve.repetitions},
            {"reference", curve.reference_is},
            {"position_error_px", study::number_json(curve.position_error)},
            {"vertices", curve.vertices},
            {"pictures", curve.different},
            {"left_out", Json::array()},
            {"faults", curve.faults},
            {"points", Json::array()}};
  for (const study::SkippedKnob& each : curve.skipped)
    json["left_out"].push_back({{"knob", name_of(each.knob)}, {"why", each.why}});
  for (const CurvePoint& point : curve.points) json["points"].push_back(point_json(report, point));
  json["second_eye"] = second_eyes_json(report.second_eyes);
  return json;
}

}  // namespace glassbox::study
