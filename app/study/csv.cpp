#include "app/study/csv.h"

#include <cstddef>

#include <fmt/format.h>

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

std::string times(const Timing* timing) {
  if (timing == nullptr) return ",,,,";
  return fmt::format("{},{},{},{},{}", timing->threads, timing->repetitions, timing->ns.median,
                     timing->ns.lower, timing->ns.upper);
}

const char* name_of(study::Standing standing) {
  return standing == study::Standing::kFront       ? "front"
         : standing == study::Standing::kDominated ? "dominated"
                                                   : "untimed";
}

}  // namespace

std::string study_csv(const study::StudyResults& results) {
  std::string text =
      "experiment,series,scene,parameter,error,error_unit,predicted_error,ratio,finding,item,"
      "threads,repetitions,ns,ns_lower,ns_upper,standing,machine,compiler,flags,version\n";
  const std::string origin =
      fmt::format("{},{},{},{}", field(results.origin.machine), field(results.origin.compiler),
                  field(results.origin.flags), field(results.origin.version));
  for (const study::ExperimentResult& experiment : results.experiments) {
    const auto all = study::standings(experiment);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const ConfigurationResult& each = experiment.configurations[i];
      const std::string first =
          fmt::format("{},{},{},{},{},{},{},{},", field(experiment.id), field(each.series),
                      field(each.scene), each.parameter, each.error, field(experiment.error_unit),
                      comparison(each), field(experiment.item));
      const std::string last = fmt::format(",{},{}\n", name_of(all[i]), origin);
      if (each.timings.empty()) text += first + times(nullptr) + last;
      for (const Timing& timing : each.timings) text += first + times(&timing) + last;
    }
  }
  return text;
}

}  // namespace glassbox::app
