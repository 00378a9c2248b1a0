#include "study/experiment/study.h"

#include "study/experiment/result_file.h"

namespace glassbox::study {

Result<StudyResults> run_study(const std::vector<const Experiment*>& chosen, const Origin& origin,
                               const RunOptions& options, const std::optional<std::string>& file) {
  StudyResults kept{origin, {}};
  if (file) {
    auto resumed = resume_results(*file, origin);
    if (!resumed) return resumed;
    kept = std::move(*resumed);
  }
  StudyResults results{origin, {}};
  for (const Experiment* experiment : chosen) {
    if (const ExperimentResult* known = find_result(kept, experiment->id)) {
      results.experiments.push_back(*known);
      continue;
    }
    results.experiments.push_back(run_experiment(*experiment, options));
    if (!file) continue;
    kept.experiments.push_back(results.experiments.back());
    if (const auto written = write_results(*file, kept); !written) {
      return tl::unexpected(written.error());
    }
  }
  return results;
}

}  // namespace glassbox::study
