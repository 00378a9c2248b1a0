#include "app/views/geometry_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "app/views/geometry_text.h"

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity.
Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

template <class Vector>
Json numbers_of(const Vector& vector) {
  Json json = Json::array();
  for (const double value : vector) json.push_back(finite(value));
  return json;
}

Json rows_of(const views::Matrix3d& matrix) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
    rows.push_back({finite(matrix(row, 0)), finite(matrix(row, 1)), finite(matrix(row, 2))});
  return rows;
}

template <class Value, class Write>
Json optional_json(const std::optional<Value>& value, const Write& write) {
  return value ? Json(write(*value)) : Json(nullptr);
}

Json pose_json(const views::RelativePose& pose) {
  return {{"R", rows_of(pose.rotation)}, {"T", numbers_of(pose.translation)}};
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
    return Json{{"K_left", rows_of(intrinsics[0])}, {"K_right", rows_of(intrinsics[1])}};
  });
  return json;
}

Json judgement_json(const views::PairJudgement& judgement) {
  return {{"kind", name_of(judgement.kind)},
          {"sentence", kind_sentence(judgement.kind)},
          {"cost_of_constraint", finite(judgement.cost_of_fundamental)},
          {"cost_of_homography", finite(judgement.cost_of_homography)},
          {"cost_of_rotation", finite(judgement.cost_of_rotation)},
          {"eighth_over_ninth", finite(judgement.eighth_over_ninth)}};
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
          {"samples_wanted", finite(report.samples_wanted)},
          {"law", law_text(report)},
          {"inliers", analysis.inliers},
          {"system",
           {{"rank", analysis.system.rank},
            {"condition_raw", finite(analysis.system.condition_raw)},
            {"condition_normalised", finite(analysis.system.condition_normalised)}}},
          {"pair_is", judgement_json(analysis.judgement)}};
}

Json residuals_json(const GeometryReport& report) {
  const auto write = [](const ResidualFacts& facts) {
    return Json{{"rms_px", finite(facts.rms)},
                {"median_px", finite(facts.median)},
                {"largest_px", finite(facts.largest)}};
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
      match["sampson_px"] = finite(report.analysis.residuals[i]);
      match["epipolar_px"] = finite(report.epipolar_distances[i]);
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
  json["F"] = optional_json(report.analysis.fundamental, rows_of);
  json["E"] = optional_json(report.essential, rows_of);
  json["E_of_shift"] = optional_json(report.essential_of_shift, rows_of);
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

}  // namespace glassbox::app
