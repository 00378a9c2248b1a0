#include "study/experiment/pareto.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace glassbox::study {

namespace {

bool dominates(const ErrorAndTime& a, const ErrorAndTime& b, bool more_is_better = false) {
  if (std::isnan(a.error)) return false;
  if (std::isnan(b.error)) return !is_faster(b.ns, a.ns);  // a has an answer, and b is not faster
  return (more_is_better ? a.error >= b.error : a.error <= b.error) && is_faster(a.ns, b.ns);
}

ErrorAndTime error_and_time_of(const ConfigurationResult& result, int threads) {
  return {result.error, timing_of(result, threads)->ns};
}

bool more_is_better(const ExperimentResult& experiment, const std::string& measure) {
  const auto found = std::ranges::find(experiment.measures, measure, &Measure::name);
  return found == experiment.measures.end() ? experiment.more_is_better : found->more_is_better;
}

}  // namespace

const char* name_of(Standing standing) {
  switch (standing) {
    case Standing::kFront:
      return "front";
    case Standing::kDominated:
      return "dominated";
    case Standing::kUntimed:
      break;
  }
  return "untimed";
}

std::vector<Standing> standings(const std::vector<ErrorAndTime>& competitors) {
  std::vector<Standing> all;
  for (const ErrorAndTime& each : competitors) {
    const bool beaten = std::ranges::any_of(
        competitors, [&](const ErrorAndTime& other) { return dominates(other, each); });
    all.push_back(beaten ? Standing::kDominated : Standing::kFront);
  }
  return all;
}

const Timing* timing_of(const ConfigurationResult& result, int threads) {
  for (const Timing& timing : result.timings) {
    if (timing.threads == threads) return &timing;
  }
  return nullptr;
}

bool are_competitors(const ExperimentResult& experiment, const ConfigurationResult& a,
                     const ConfigurationResult& b) {
  return a.measure == b.measure && a.scene == b.scene &&
         (experiment.axis_is_chosen || a.parameter == b.parameter);
}

std::vector<Standing> standings(const ExperimentResult& experiment, int threads) {
  std::vector<Standing> all;
  for (const ConfigurationResult& each : experiment.configurations) {
    Standing standing = Standing::kUntimed;
    if (timing_of(each, threads) != nullptr) {
      standing = Standing::kFront;
      const bool more = more_is_better(experiment, each.measure);
      for (const ConfigurationResult& other : experiment.configurations) {
        if (timing_of(other, threads) == nullptr || !are_competitors(experiment, each, other))
          continue;
        if (dominates(error_and_time_of(other, threads), error_and_time_of(each, threads), more))
          standing = Standing::kDominated;
      }
    }
    all.push_back(standing);
  }
  return all;
}

std::vector<int> thread_counts(const ExperimentResult& experiment) {
  std::set<int> counts;
  for (const ConfigurationResult& each : experiment.configurations) {
    for (const Timing& timing : each.timings) counts.insert(timing.threads);
  }
  return {counts.begin(), counts.end()};
}

}  // namespace glassbox::study
