#include <cmath>

#include <nlohmann/json.hpp>

#include "labs/commands/report.h"

#include "labs/framework/slips.h"

namespace glassbox::labs {

namespace {

using Json = nlohmann::ordered_json;

Json number_json(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

Json divergence_json(const Divergence& found) {
  return {{"kind", labs::kind_name(found.kind)},
          {"field", found.field},
          {"index", found.index},
          {"element", found.element},
          {"expected", number_json(found.expected)},
          {"actual", number_json(found.actual)},
          {"distance", number_json(found.distance)},
          {"ulps", number_json(found.ulps)},
          {"ulps_of", found.ulps_of_double ? "double" : "float"},
          {"unit", found.unit},
          {"bound", number_json(found.bound)},
          {"explanation", found.explanation}};
}

Json first_json(const LabReport& report, const CheckResult& check) {
  const labs::FirstFailure& first = *check.first;
  const Restated restated = restated_lines(first.restated);
  Json json{{"case", first.index},
            {"where", first.where},
            {"stage", check.stage},
            {"status", labs::verdict_name(first.verdict)},
            {"outcome", outcome_text(report, check)}};
  if (!first.text.empty()) json["text"] = first.text;
  if (first.divergence) json.update(divergence_json(*first.divergence));
  if (first.comparison && first.expected->shape == labs::Shape::kCoverage) {
    const labs::CoverageCounts& counts = first.comparison->coverage;
    json["coverage"] = {
        {"gaps", counts.gaps}, {"doubles", counts.doubles}, {"extra", counts.extra}};
    json["map"] = first.comparison->map;
  }
  json["restated"] = restated.facts;
  json["commands"] = restated.commands;
  json["debugger"] = debugger_command(report, check);
  json["slips"] = Json::array();
  for (const std::string& slip : check.slips)
    json["slips"].push_back({{"id", slip}, {"text", labs::slip_text(slip)}});
  return json;
}

Json check_json(const LabReport& report, const CheckResult& check) {
  Json json{{"name", check.name},
            {"task", check.task},
            {"stage", check.stage},
            {"hidden", check.hidden},
            {"score", check.score},
            {"max_score", check.max_score},
            {"status", labs::verdict_name(check.verdict)},
            {"cases", check.cases.size()},
            {"right", check.right},
            {"seconds", check.seconds},
            {"first_divergence", nullptr}};
  if (check.first) json["first_divergence"] = first_json(report, check);
  if (!check.printed.empty()) json["printed"] = check.printed;
  return json;
}

}  // namespace

Json lab_report_json(const LabReport& report) {
  const labs::LabResult& result = report.result;
  Json json{{"lab", result.folder},          {"number", result.number},
            {"title", result.title},         {"score", result.score},
            {"max_score", result.max_score}, {"hidden_points", result.hidden_points},
            {"seconds", report.seconds}};
  json["compile_error"] = result.not_built.empty() ? Json() : Json(result.not_built);
  json["tasks"] = Json::array();
  for (const labs::TaskResult& task : result.tasks)
    json["tasks"].push_back({{"id", task.id},
                             {"title", task.title},
                             {"score", task.score},
                             {"max_score", task.max_score}});
  json["tests"] = Json::array();
  for (const CheckResult& check : result.checks) json["tests"].push_back(check_json(report, check));
  return json;
}

}  // namespace glassbox::labs
