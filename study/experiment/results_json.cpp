#include "study/experiment/results_json.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
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

// `standing` has one value for each timing, in the same order (by number of threads).
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

// The reason why a file cannot be read.
struct UnreadableFile {
  std::string cause;
};

const Json& field(const Json& json, const char* name) {
  if (const auto found = json.find(name); found != json.end()) return *found;
  throw UnreadableFile{std::string("has no '") + name +
                       "', so it was written by an older version, or is damaged"};
}

Measure measure_of(const Json& json) {
  return {field(json, "name"),          field(json, "error"),     field(json, "error_unit"),
          field(json, "axis"),          field(json, "axis_unit"), field(json, "logarithmic_axis"),
          field(json, "more_is_better")};
}

double number_of(const Json& json) {
  if (!json.is_string()) return json.get<double>();
  const auto& name = json.get_ref<const std::string&>();
  if (name == "infinity") return kInfinity;
  if (name == "-infinity") return -kInfinity;
  if (name == "nan") return std::numeric_limits<double>::quiet_NaN();
  throw UnreadableFile{"is damaged: '" + name + "' is not a number"};
}

Timing timing_of(const Json& json) {
  const Json& quartiles = field(json, "ns_quartiles");
  const Json& octiles = field(json, "ns_octiles");
  return {field(json, "threads"),
          field(json, "repetitions"),
          {number_of(quartiles.at(0)), number_of(field(json, "ns")), number_of(quartiles.at(1)),
           number_of(octiles.at(0)), number_of(octiles.at(1))},
          field(json, "disturbed")};
}

ConfigurationResult configuration_of(const Json& json) {
  ConfigurationResult result;
  result.series = field(json, "series");
  result.parameter = number_of(field(json, "parameter"));
  result.scene = field(json, "scene");
  result.measure = field(json, "measure");
  result.error = number_of(field(json, "error"));
  if (!field(json, "predicted_error").is_null())
    result.predicted_error = number_of(json["predicted_error"]);
  if (const Json& range = field(json, "explains"); !range.is_null()) {
    result.explanation = {field(json, "explanation"), range.at(0), range.at(1)};
  }
  for (const Json& each : field(json, "times")) result.timings.push_back(timing_of(each));
  return result;
}

ExperimentResult experiment_of(const Json& json) {
  ExperimentResult result;
  result.id = field(json, "id");
  result.name = field(json, "name");
  result.question = field(json, "question");
  result.axis = field(json, "axis");
  result.axis_unit = field(json, "axis_unit");
  result.logarithmic_axis = field(json, "logarithmic_axis");
  result.axis_is_chosen = field(json, "axis_is_chosen");
  result.error = field(json, "error");
  result.error_unit = field(json, "error_unit");
  result.reference = field(json, "reference");
  result.theory = field(json, "theory");
  result.item = field(json, "item");
  result.machine = {number_of(field(json, "load")), number_of(field(json, "mhz"))};
  for (const Json& each : field(json, "measures")) result.measures.push_back(measure_of(each));
  for (const Json& each : field(json, "configurations"))
    result.configurations.push_back(configuration_of(each));
  return result;
}

StudyResults unchecked_results_of(const Json& json) {
  StudyResults results;
  const std::string effort = field(json, "effort");
  if (effort != "quick" && effort != "full") {
    throw UnreadableFile{"is damaged: '" + effort + "' is not an effort (quick or full)"};
  }
  results.origin = {field(json, "machine"),
                    field(json, "compiler"),
                    field(json, "flags"),
                    field(json, "version"),
                    effort == "quick" ? Effort::kQuick : Effort::kFull,
                    field(json, "threads"),
                    field(json, "part").at(0),
                    field(json, "part").at(1),
                    field(json, "target"),
                    field(json, "caches")};
  const Origin& origin = results.origin;
  if (origin.part < 1 || origin.part > origin.parts || origin.parts > kMaxParts) {
    throw UnreadableFile{"is damaged: its part does not exist"};
  }
  for (const Json& each : field(json, "experiments"))
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
  std::map<int, std::vector<Standing>> all;  // keys: number of threads
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
    return fail("", "is not a result file of glassbox study run", kRemedy);
  }
  try {
    return unchecked_results_of(json);
  } catch (const UnreadableFile& unread) {
    return fail("", unread.cause, kRemedy);
  } catch (const Json::exception&) {
    return fail("", "is damaged: a value has the wrong type", kRemedy);
  }
}

}  // namespace glassbox::study
