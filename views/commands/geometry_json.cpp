#include "views/commands/geometry_json.h"

#include <nlohmann/json.hpp>

#include "views/commands/geometry_text.h"
#include "views/commands/matrix_report.h"

namespace glassbox::views {

namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json numbers_of(const Vector& vector) {
  Json json = Json::array();
  for (const double value : vector) json.push_back(finite_json(value));
  return json;
}

template <class Value, class Write>
Json optional_json(const std::optional<Value>& value, const Write& write) {
  return value ? Json(write(*value)) : Json(nullptr);
}

Json pose_json(const views::RelativePose& pose) {
  return {{"R", matrix_json(pose.rotation)}, {"T", numbers_of(pose.translation)}};
}

Json input_json(const GeometryInput& input) {
  Json json{{"about", input.about}};
  if (!input.made_how.empty()) json["pair"] = input.made_how;
  if (input.pictures) {
    json["width"] = input.pictures->front().width;
    json["height"] = input.pictures->front().height;
  }
  if (const auto& fates = input.fates) {
    json["left_pixels"] = {{"seen", fates->seen},
                           {"hidden", fates->hidden},
                           {"beside", fates->beside},
                           {"missing", fates->missing},
                           {"nothing_drawn", fates->nothing}};
  }
  json["cameras"] = optional_json(input.intrinsics, [](const auto& intrinsics) {
    return Json{{"K_left", matrix_json(intrinsics[0])}, {"K_right", matrix_json(intrinsics[1])}};
  });
  return json;
}

Json judgement_json(const views::PairJudgement& judgement) {
  return {{"kind", name_of(judgement.kind)},
          {"sentence", kind_sentence(judgement.kind)},
          {"cost_of_constraint", finite_json(judgement.cost_of_fundamental)},
          {"cost_of_homography", finite_json(judgement.cost_of_homography)},
          {"cost_of_rotation", finite_json(judgement.cost_of_rotation)},
          {"eighth_over_ninth", finite_json(judgement.eighth_over_ninth)}};
}

Json estimation_json(const GeometryReport& report) {
  const views::PairQuestion& question = report.question;
  const views::PairAnalysis& analysis = report.analysis;
  return {{"estimator", name_of(question.estimator)},
          {"sigma_px", question.sigma},
          {"threshold_px", question.ransac.threshold},
          {"confidence", question.ransac.confidence},
          {"seed", question.ransac.seed},
          {"samples", analysis.samples},
          {"samples_wanted", finite_json(report.samples_wanted)},
          {"law", law_text(report)},
          {"inliers", analysis.inliers},
          {"system",
           {{"rank", analysis.system.rank},
            {"condition_raw", finite_json(analysis.system.condition_raw)},
            {"condition_normalised", finite_json(analysis.system.condition_normalised)}}},
          {"pair_is", judgement_json(analysis.judgement)}};
}

Json residuals_json(const GeometryReport& report) {
  const auto write = [](const ResidualFacts& facts) {
    return Json{{"rms_px", finite_json(facts.rms)},
                {"median_px", finite_json(facts.median)},
                {"largest_px", finite_json(facts.largest)}};
  };
  return {{"sampson", write(report.sampson)}, {"epipolar", write(report.epipolar)}};
}

Json candidates_json(const std::vector<PoseCandidate>& candidates) {
  Json json = Json::array();
  for (const PoseCandidate& one : candidates) {
    Json pose = pose_json(one.pose);
    pose["in_front"] = one.in_front;
    pose["chosen"] = one.is_chosen;
    json.push_back(std::move(pose));
  }
  return json;
}

Json truth_json(const GeometryInput& input, const GeometryReport& report) {
  Json json = optional_json(input.truth, pose_json);
  if (const auto& errors = report.errors) {
    json["rotation_error_degrees"] = errors->rotation_degrees;
    json["direction_error_degrees"] =
        optional_json(errors->direction_degrees, [](double angle) { return angle; });
  }
  if (const auto& facts = report.outliers) {
    json["outliers"] = {
        {"planted", facts->planted}, {"kept", facts->kept}, {"lost_matches", facts->lost}};
  }
  return json;
}

Json matches_json(const GeometryInput& input, const GeometryReport& report) {
  Json json = Json::array();
  for (std::size_t i = 0; i < input.matches.size(); ++i) {
    Json match{{"left", numbers_of(input.matches[i].left)},
               {"right", numbers_of(input.matches[i].right)},
               {"inlier", bool(report.analysis.is_inlier[i])}};
    if (report.has_geometry()) {
      match["sampson_px"] = finite_json(report.analysis.residuals[i]);
      match["epipolar_px"] = finite_json(report.epipolar_distances[i]);
    }
    if (!input.is_outlier.empty()) match["planted_outlier"] = bool(input.is_outlier[i]);
    json.push_back(std::move(match));
  }
  return json;
}

}  // namespace

Json geometry_json(const GeometryInput& input, const GeometryReport& report) {
  Json json = input_json(input);
  json.update(estimation_json(report));
  json["residuals"] = report.has_geometry() ? residuals_json(report) : Json(nullptr);
  json["F"] = optional_json(report.analysis.fundamental, matrix_json);
  json["E"] = optional_json(report.essential, matrix_json);
  json["E_of_shift"] = optional_json(report.essential_of_shift, matrix_json);
  json["pose"] = optional_json(report.analysis.pose, pose_json);
  json["epipoles"] = optional_json(report.epipoles, [](const auto& epipoles) {
    return Json{{"left", numbers_of(epipoles[0])}, {"right", numbers_of(epipoles[1])}};
  });
  json["four_poses"] = candidates_json(report.candidates);
  json["truth"] = truth_json(input, report);
  Json left_out = Json::array();
  for (const LeftOut& one : report.left_out)
    left_out.push_back({{"what", one.what}, {"why", one.why}});
  json["left_out"] = std::move(left_out);
  json["matches"] = matches_json(input, report);
  return json;
}

}  // namespace glassbox::views
