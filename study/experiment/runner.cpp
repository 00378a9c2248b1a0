#include "study/experiment/runner.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "study/bench/machine.h"
#include "study/experiment/timing.h"

namespace glassbox::study {

namespace {

void report_phase(const RunOptions& options, const std::string& what) {
  if (options.phase) options.phase(what);
}

ExperimentResult described(const Experiment& experiment) {
  ExperimentResult result;
  result.id = experiment.id;
  result.name = experiment.name;
  result.question = experiment.question;
  result.axis = experiment.axis;
  result.axis_unit = experiment.axis_unit;
  result.logarithmic_axis = experiment.logarithmic_axis;
  result.axis_is_chosen = experiment.axis_is_chosen;
  result.error = experiment.error;
  result.error_unit = experiment.error_unit;
  result.reference = experiment.reference;
  result.theory = experiment.theory;
  result.item = experiment.item;
  for (Measure measure : experiment.measures) {
    if (measure.axis.empty()) {
      measure.axis = experiment.axis;
      measure.axis_unit = experiment.axis_unit;
      measure.logarithmic_axis = experiment.logarithmic_axis;
    }
    result.measures.push_back(std::move(measure));
  }
  return result;
}

ConfigurationResult measured_error(const Configuration& configuration) {
  ConfigurationResult result;
  result.series = configuration.series;
  result.parameter = configuration.parameter;
  result.scene = configuration.scene;
  result.measure = configuration.measure;
  result.error = configuration.error();
  result.predicted_error = configuration.predicted_error;
  result.explanation = configuration.finding;
  return result;
}

void add_times(const std::vector<Configuration>& configurations, int threads, int repetitions,
               ExperimentResult& result) {
  std::vector<TimedWork> works;
  std::vector<std::size_t> of;  // index of the configuration of each work
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    const Configuration& each = configurations[i];
    if (!each.work) continue;
    works.push_back({[&each, threads] { each.work(threads); }, each.items, threads});
    of.push_back(i);
  }
  const std::vector<Timed> times = time_in_turn(works, repetitions);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto& [ns, disturbed] = times[i];
    result.configurations[of[i]].timings.push_back({threads, repetitions, ns, disturbed});
  }
}

std::string axis_of(const ExperimentResult& result, const ConfigurationResult& each) {
  const auto found = std::ranges::find(result.measures, each.measure, &Measure::name);
  return found == result.measures.end() ? result.axis : found->axis;
}

// Copies times to configurations that have no work of their own: the times of the configuration
// with the same series, the same scene and the same place on the same axis.
void share_times(ExperimentResult& result) {
  const std::vector<ConfigurationResult> timed = result.configurations;
  for (ConfigurationResult& each : result.configurations) {
    if (each.measure.empty() || !each.timings.empty()) continue;
    const auto same = std::ranges::find_if(timed, [&](const ConfigurationResult& other) {
      return !other.timings.empty() && other.series == each.series && other.scene == each.scene &&
             other.parameter == each.parameter && axis_of(result, other) == axis_of(result, each);
    });
    if (same != timed.end()) each.timings = same->timings;
  }
}

std::string lower_case(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

ExperimentResult run_experiment(const Experiment& experiment, const RunOptions& options) {
  report_phase(options, experiment.id + ": preparing");
  const std::vector<Configuration> configurations = experiment.configurations(options.effort);
  ExperimentResult result = described(experiment);
  for (const Configuration& each : configurations) {
    report_phase(options, fmt::format("{}: error {} of {}", experiment.id,
                                      result.configurations.size() + 1, configurations.size()));
    result.configurations.push_back(measured_error(each));
  }
  report_phase(options, experiment.id + ": times with one thread");
  result.machine = machine_state();
  add_times(configurations, 1, options.repetitions, result);
  if (experiment.threaded && options.threads > 1) {
    report_phase(options, fmt::format("{}: times with {} threads", experiment.id, options.threads));
    add_times(configurations, options.threads, options.repetitions, result);
  }
  share_times(result);
  return result;
}

const Experiment* find_experiment(const std::vector<Experiment>& all, const std::string& id) {
  const auto found = std::ranges::find_if(
      all, [&](const Experiment& each) { return lower_case(each.id) == lower_case(id); });
  return found == all.end() ? nullptr : &*found;
}

Origin current_origin(const std::string& version, Effort effort, int threads) {
  return {
      machine_name(),    compiler_name(), GLASSBOX_COMPILE_FLAGS, version, effort, threads, 1, 1,
      instruction_set(), cache_sizes()};
}

}  // namespace glassbox::study
