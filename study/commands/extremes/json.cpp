#include <cmath>

#include <nlohmann/json.hpp>

#include "study/commands/extremes/report.h"

namespace glassbox::study {

namespace {

using nlohmann::ordered_json;
using study::Outcome;

// The number, or a word for it if it is infinite: JSON cannot represent infinity.
ordered_json number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
  return value;
}
ordered_json number(const std::optional<double>& value) {
  return value ? number(*value) : ordered_json(nullptr);
}

ordered_json outcome_json(const std::string& name, const Outcome& outcome) {
  return {{"name", name},
          {"error", number(outcome.error)},
          {"bound", number(outcome.bound)},
          {"condition", number(outcome.condition)},
          {"passes", outcome.passes()},
          {"seen", outcome.seen}};
}

ordered_json case_json(const study::CaseResult& r) {
  auto mutants = ordered_json::array();
  for (std::size_t i = 0; i < r.mutants.size(); ++i) {
    mutants.push_back(outcome_json(r.what.mutants[i].name, r.mutants[i]));
  }
  auto drawn = ordered_json::array();
  for (std::size_t i = 0; i < r.drawn.size(); ++i) {
    drawn.push_back(outcome_json(study::drawers()[i].name, r.drawn[i]));
  }
  return {{"id", r.what.id},
          {"name", r.what.name},
          {"construction", r.what.construction},
          {"stage", r.what.stage},
          {"right", r.what.right},
          {"unit", r.what.unit},
          {"oracle", oracle_name(r.what.oracle)},
          {"ours", outcome_json(r.what.ours.name, r.ours)},
          {"naive", outcome_json(r.what.naive.name, r.naive)},
          {"mutants", mutants},
          {"drawn", drawn},
          {"not_drawn", r.what.not_drawn},
          {"holds", r.holds()}};
}

ordered_json sweep_json(const SweepResult& result) {
  const study::Sweep& what = result.what;
  auto all = ordered_json::array();
  for (const study::SweepSeries& series : result.series) {
    auto points = ordered_json::array();
    for (const study::SweepPoint& point : series.points) {
      points.push_back({{"parameter", number(point.parameter)},
                        {"error", number(point.error)},
                        {"bound", number(point.bound)}});
    }
    all.push_back({{"name", series.name},
                   {"ours", series.ours},
                   {"gives_up", number(series.gives_up)},
                   {"within_bounds", study::within_bounds(series)},
                   {"points", points}});
  }
  return {{"name", what.name},
          {"title", what.title},
          {"question", what.question},
          {"axis", what.axis},
          {"axis_unit", what.axis_unit},
          {"error", what.error},
          {"error_unit", what.error_unit},
          {"reference", what.reference},
          {"bound", what.bound},
          {"tolerance", what.tolerance},
          {"series", all},
          {"holds", result.holds()}};
}

}  // namespace

ordered_json extremes_json(const ExtremesReport& report) {
  ordered_json json{{"holds", report.holds()}};
  json["cases"] = ordered_json::array();
  for (const auto& each : report.cases) json["cases"].push_back(case_json(each));
  json["sweeps"] = ordered_json::array();
  for (const auto& each : report.sweeps) json["sweeps"].push_back(sweep_json(each));
  json["left_out"] = ordered_json::array();
  for (const study::LeftOut& each : study::left_out_cases()) {
    json["left_out"].push_back({{"id", each.id}, {"name", each.name}, {"reason", each.reason}});
  }
  return json;
}

}  // namespace glassbox::study
