#include "study/experiment/results_json.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/experiment/pareto.h"
#include "study/experiment/theory.h"

namespace glassbox::study {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "glassbox study results 3";
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const char* name_of(Effort effort) {
  return effort == Effort::kQuick ? "quick" : "full";
}

// `standing` by number of threads, in the order of the timings.
Json configuration_json(const ConfigurationResult& result, const std::vector<Standing>& standing) {
  Json json{{"series", result.series},
            {"parameter", number_json(result.parameter)},
            {"scene", result.scene},
            {"measure", result.measure},
            {"error", number_json(result.error)},
            {"predicted_error", nullptr},
            {"ratio", nullptr},
            {"finding", false},
            {"explanation", ""},
            {"explains", nullptr},
            {"times", Json::array()}};
  if (const auto check = check_theory(result)) {
    json["predicted_error"] = number_json(*result.predicted_error);
    json["ratio"] = number_json(check->ratio);
    json["finding"] = check->finding;
  }
  if (result.explanation) {
    json["explanation"] = result.explanation->why;
    json["explains"] = {result.explanation->least, result.explanation->greatest};
  }
  for (std::size_t i = 0; i < result.timings.size(); ++i) {
    const Timing& timing = result.timings[i];
    json["times"].push_back({{"threads", timing.threads},
                             {"repetitions", timing.repetitions},
                             {"ns", timing.ns.median},
                             {"ns_quartiles", {timing.ns.lower, timing.ns.upper}},
                             {"ns_octiles", {timing.ns.first_octile, timing.ns.last_octile}},
                             {"disturbed", timing.disturbed},
                             {"standing", name_of(standing[i])}});
  }
  return json;
}

Json measure_json(const Measure& measure) {
  return {{"name", measure.name},
          {"error", measure.error},
          {"error_unit", measure.error_unit},
          {"axis", measure.axis},
          {"axis_unit", measure.axis_unit},
          {"logarithmic_axis", measure.logarithmic_axis},
          {"more_is_better", measure.more_is_better}};
}

Measure measure_of(const Json& json) {
  return {json.at("name"),          json.at("error"),     json.at("error_unit"),
          json.at("axis"),          json.at("axis_unit"), json.at("logarithmic_axis"),
          json.at("more_is_better")};
}

double number_of(const Json& json) {
  if (!json.is_string()) return json.get<double>();
  const auto& name = json.get_ref<const std::string&>();
  if (name == "infinity") return kInfinity;
  if (name == "-infinity") return -kInfinity;
  if (name == "nan") return std::numeric_limits<double>::quiet_NaN();
  throw Json::other_error::create(501, "'" + name + "' is no number", &json);
}

Timing timing_of(const Json& json) {
  const Json& quartiles = json.at("ns_quartiles");
  const Json& octiles = json.at("ns_octiles");
  return {json.at("threads"),
          json.at("repetitions"),
          {number_of(quartiles.at(0)), number_of(json.at("ns")), number_of(quartiles.at(1)),
           number_of(octiles.at(0)), number_of(octiles.at(1))},
          json.at("disturbed")};
}

ConfigurationResult configuration_of(const Json& json) {
  ConfigurationResult result;
  result.series = json.at("series");
  result.parameter = number_of(json.at("parameter"));
  result.scene = json.at("scene");
  result.measure = json.at("measure");
  result.error = number_of(json.at("error"));
  if (!json.at("predicted_error").is_null())
    result.predicted_error = number_of(json["predicted_error"]);
  if (const Json& range = json.at("explains"); !range.is_null()) {
    result.explanation = {json.at("explanation"), range.at(0), range.at(1)};
  }
  for (const Json& each : json.at("times")) result.timings.push_back(timing_of(each));
  return result;
}

ExperimentResult experiment_of(const Json& json) {
  ExperimentResult result;
  result.id = json.at("id");
  result.name = json.at("name");
  result.question = json.at("question");
  result.axis = json.at("axis");
  result.axis_unit = json.at("axis_unit");
  result.logarithmic_axis = json.at("logarithmic_axis");
  result.axis_is_chosen = json.at("axis_is_chosen");
  result.error = json.at("error");
  result.error_unit = json.at("error_unit");
  result.reference = json.at("reference");
  result.theory = json.at("theory");
  result.item = json.at("item");
  result.machine = {number_of(json.at("load")), number_of(json.at("mhz"))};
  for (const Json& each : json.at("measures")) result.measures.push_back(measure_of(each));
  for (const Json& each : json.at("configurations"))
    result.configurations.push_back(configuration_of(each));
  return result;
}

StudyResults unchecked_results_of(const Json& json) {
  StudyResults results;
  const std::string effort = json.at("effort");
  if (effort != "quick" && effort != "full") {
    throw Json::other_error::create(501, "'" + effort + "' is no effort", &json);
  }
  results.origin = {json.at("machine"),
                    json.at("compiler"),
                    json.at("flags"),
                    json.at("version"),
                    effort == "quick" ? Effort::kQuick : Effort::kFull,
                    json.at("threads"),
                    json.at("part").at(0),
                    json.at("part").at(1),
                    json.at("target"),
                    json.at("caches")};
  const Origin& origin = results.origin;
  if (origin.part < 1 || origin.part > origin.parts || origin.parts > kMostParts) {
    throw Json::other_error::create(501, "there is no such part", &json);
  }
  for (const Json& each : json.at("experiments"))
    results.experiments.push_back(experiment_of(each));
  return results;
}

}  // namespace

Json number_json(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
  return value;
}

Json experiment_json(const ExperimentResult& result) {
  Json json{{"id", result.id},
            {"name", result.name},
            {"question", result.question},
            {"axis", result.axis},
            {"axis_unit", result.axis_unit},
            {"logarithmic_axis", result.logarithmic_axis},
            {"axis_is_chosen", result.axis_is_chosen},
            {"error", result.error},
            {"error_unit", result.error_unit},
            {"reference", result.reference},
            {"theory", result.theory},
            {"item", result.item},
            {"load", number_json(result.machine.load)},
            {"mhz", number_json(result.machine.mhz)},
            {"measures", Json::array()},
            {"configurations", Json::array()}};
  for (const Measure& each : result.measures) json["measures"].push_back(measure_json(each));
  std::map<int, std::vector<Standing>> all;  // by number of threads
  for (const int threads : thread_counts(result)) all[threads] = standings(result, threads);
  for (std::size_t i = 0; i < result.configurations.size(); ++i) {
    std::vector<Standing> standing;
    for (const Timing& timing : result.configurations[i].timings)
      standing.push_back(all[timing.threads][i]);
    json["configurations"].push_back(configuration_json(result.configurations[i], standing));
  }
  return json;
}

Json results_json(const StudyResults& results) {
  const Origin& origin = results.origin;
  Json json{{"format", kFormat},           {"version", origin.version},
            {"machine", origin.machine},   {"target", origin.target},
            {"caches", origin.caches},     {"compiler", origin.compiler},
            {"flags", origin.flags},       {"effort", name_of(origin.effort)},
            {"threads", origin.threads},   {"part", {origin.part, origin.parts}},
            {"experiments", Json::array()}};
  for (const ExperimentResult& each : results.experiments)
    json["experiments"].push_back(experiment_json(each));
  return json;
}

Result<StudyResults> results_of(const Json& json) {
  constexpr const char* kRemedy = "give a file that this version of glassbox study run has written";
  if (!json.is_object() || json.value("format", Json()) != kFormat) {
    return fail("", "is no result file of the study", kRemedy);
  }
  try {
    return unchecked_results_of(json);
  } catch (const Json::exception& error) {
    return fail("", std::string("is damaged: ") + error.what(), kRemedy);
  }
}

}  // namespace glassbox::study
