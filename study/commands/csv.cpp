#include "study/commands/report.h"

#include <cstddef>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "cli/report/text_layout.h"
#include "study/experiment/measures.h"
#include "study/experiment/pareto.h"
#include "study/experiment/theory.h"

namespace glassbox::study {

namespace {

std::string comparison(const ConfigurationResult& result) {
  const auto check = study::check_theory(result);
  if (!check) return ",,";
  return fmt::format("{},{},{}", *result.predicted_error, check->ratio, check->finding ? 1 : 0);
}

// The fields of a line about time: threads, repetitions, times, and whether the configuration is on
// the Pareto front (its standing).
std::string times(const Timing* timing, study::Standing standing) {
  if (timing == nullptr) return ",,,,,,untimed";
  return fmt::format("{},{},{},{},{},{},{}", timing->threads, timing->repetitions,
                     timing->ns.median, timing->ns.lower, timing->ns.upper, timing->disturbed,
                     name_of(standing));
}

std::string experiment_lines(const study::ExperimentResult& experiment, const std::string& origin) {
  std::string text;
  std::map<int, std::vector<study::Standing>> all;  // for each number of threads
  for (const int threads : study::thread_counts(experiment))
    all[threads] = study::standings(experiment, threads);
  for (std::size_t i = 0; i < experiment.configurations.size(); ++i) {
    const ConfigurationResult& each = experiment.configurations[i];
    const std::string first =
        fmt::format("{},{},{},{},{},{},{},{},{},", csv_field(experiment.id), csv_field(each.series),
                    csv_field(each.scene), csv_field(each.measure), each.parameter, each.error,
                    csv_field(experiment.error_unit), comparison(each), csv_field(experiment.item));
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
      fmt::format(",{},{},{},{},{},{}\n", csv_field(from.machine), csv_field(from.target),
                  csv_field(from.caches), csv_field(from.compiler), csv_field(from.flags),
                  csv_field(from.version));
  for (const study::ExperimentResult& experiment : results.experiments) {
    for (const study::ExperimentResult& each : study::by_measure(experiment))
      text += experiment_lines(each, origin);
  }
  return text;
}

}  // namespace glassbox::study
