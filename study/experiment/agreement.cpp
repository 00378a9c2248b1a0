#include "study/experiment/agreement.h"

#include <algorithm>

#include <fmt/format.h>

#include "study/experiment/pareto.h"

#include <glassbox/base/counted.h>

namespace glassbox::study {

namespace {

bool are_the_same(const ConfigurationResult& a, const ConfigurationResult& b) {
  return a.series == b.series && a.parameter == b.parameter && a.scene == b.scene &&
         a.measure == b.measure;
}

// Returns -1 if the first is faster, 1 if the second is, 0 if the times do not decide it.
int order(const Timing& first, const Timing& second) {
  if (is_faster(first.ns, second.ns)) return -1;
  return is_faster(second.ns, first.ns) ? 1 : 0;
}

std::string name_of(const ConfigurationResult& result) {
  std::string name = fmt::format("{} at {:g}", result.series, result.parameter);
  return result.scene.empty() ? name : name + ", " + result.scene;
}

void compare(const ExperimentResult& one, const ExperimentResult& other, int threads,
             Agreement& found) {
  const auto& configurations = one.configurations;
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    for (std::size_t j = i + 1; j < configurations.size(); ++j) {
      if (!are_competitors(one, configurations[i], configurations[j])) continue;
      const Timing* const times[] = {
          timing_of(configurations[i], threads), timing_of(configurations[j], threads),
          timing_of(other.configurations[i], threads), timing_of(other.configurations[j], threads)};
      if (std::ranges::find(times, nullptr) != std::end(times)) continue;
      ++found.compared;
      const int here = order(*times[0], *times[1]), there = order(*times[2], *times[3]);
      found.by_both += here != 0 && there != 0;
      found.by_one += (here != 0) != (there != 0);
      if (here * there >= 0) continue;
      const std::string first = name_of(configurations[i]), second = name_of(configurations[j]);
      found.contradictions.push_back(
          fmt::format("{}, {}: {} is {} than {} in one run, and {} in the other", one.id,
                      counted(threads, "thread"), first, here < 0 ? "faster" : "slower", second,
                      here < 0 ? "slower" : "faster"));
    }
  }
}

}  // namespace

Result<Agreement> find_agreement(const StudyResults& one, const StudyResults& other) {
  Agreement found;
  bool any = false;
  for (const ExperimentResult& experiment : one.experiments) {
    const auto match = std::ranges::find(other.experiments, experiment.id, &ExperimentResult::id);
    if (match == other.experiments.end()) continue;
    if (!std::ranges::equal(experiment.configurations, match->configurations, are_the_same)) {
      return fail(experiment.id, "the two runs have different configurations of this experiment",
                  "compare runs of the same version and effort");
    }
    any = true;
    for (const int threads : thread_counts(experiment)) compare(experiment, *match, threads, found);
  }
  if (!any)
    return fail("", "the two runs have no experiment in common", "run the same experiments twice");
  return found;
}

}  // namespace glassbox::study
