#include "app/study/csv.h"

#include <cstddef>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "study/experiment/measures.h"
#include "study/experiment/pareto.h"
#include "study/experiment/theory.h"

namespace glassbox::app {

namespace {

using study::ConfigurationResult;
using study::Timing;

// As RFC 4180 asks for.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string comparison(const ConfigurationResult& result) {
  const auto check = study::check_theory(result);
  if (!check) return ",,";
  return fmt::format("{},{},{}", *result.predicted_error, check->ratio, check->finding ? 1 : 0);
}

// The last fields of a line: threads, repetitions, times, standing.
std::string times(const Timing* timing, study::Standing standing) {
  if (timing == nullptr) return ",,,,,,untimed";
  return fmt::format("{},{},{},{},{},{},{}", timing->threads, timing->repetitions,
                     timing->ns.median, timing->ns.lower, timing->ns.upper, timing->disturbed,
                     name_of(standing));
}

std::string experiment_lines(const study::ExperimentResult& experiment, const std::string& origin) {
  std::string text;
  std::map<int, std::vector<study::Standing>> all;  // by number of threads
  for (const int threads : study::thread_counts(experiment))
    all[threads] = study::standings(experiment, threads);
  for (std::size_t i = 0; i < experiment.configurations.size(); ++i) {
    const ConfigurationResult& each = experiment.configurations[i];
    const std::string first =
        fmt::format("{},{},{},{},{},{},{},{},{},", field(experiment.id), field(each.series),
                    field(each.scene), field(each.measure), each.parameter, each.error,
                    field(experiment.error_unit), comparison(each), field(experiment.item));
    const std::string last =
        fmt::format(",{},{}", experiment.machine.load, experiment.machine.mhz) + origin;
    if (each.timings.empty()) text += first + times(nullptr, {}) + last;
    for (const Timing& timing : each.timings)
      text += first + times(&timing, all[timing.threads][i]) + last;
  }
  return text;
}

}  // namespace

std::string study_csv(const study::StudyResults& results) {
  std::string text =
      "experiment,series,scene,measure,parameter,error,error_unit,predicted_error,ratio,finding,"
      "item,threads,repetitions,ns,ns_lower,ns_upper,disturbed,standing,load,mhz,machine,target,"
      "caches,compiler,flags,version\n";
  const study::Origin& from = results.origin;
  const std::string origin =
      fmt::format(",{},{},{},{},{},{}\n", field(from.machine), field(from.target),
                  field(from.caches), field(from.compiler), field(from.flags), field(from.version));
  for (const study::ExperimentResult& experiment : results.experiments) {
    for (const study::ExperimentResult& each : study::by_measure(experiment))
      text += experiment_lines(each, origin);
  }
  return text;
}

}  // namespace glassbox::app
