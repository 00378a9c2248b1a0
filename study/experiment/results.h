// What a run of the study has found: plain data, as the result file keeps it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/bench/machine.h"
#include "study/bench/statistics.h"
#include "study/experiment/experiment.h"

namespace glassbox::study {

struct Timing {
  int threads = 1;
  int repetitions = 0;
  Quartiles ns;       // for one item
  int disturbed = 0;  // of the repetitions (timing.h)
};

struct ConfigurationResult {
  std::string series;
  double parameter = 0;
  std::string scene, measure;
  double error = 0;
  std::optional<double> predicted_error;
  std::optional<Finding> explanation;  // of why theory and measurement differ
  std::vector<Timing> timings;  // by number of threads, ascending; empty where nothing is timed
};

struct ExperimentResult {
  // Experiment's fields of the same names.
  std::string id, name, question, axis, axis_unit;
  bool logarithmic_axis = true, axis_is_chosen = false;
  bool more_is_better = false;  // a measure's
  std::string error, error_unit, reference, theory, item;
  std::vector<Measure> measures;  // each with an axis
  MachineState machine;           // when its times began to be measured
  std::vector<ConfigurationResult> configurations;
};

inline constexpr int kMostParts = 1000;

// Results of different origins are not comparable: errors by version, times by all of it.
struct Origin {
  std::string machine, compiler, flags, version;
  Effort effort = Effort::kQuick;
  int threads = 1;                       // the most that were used
  int part = 1, parts = 1;               // of the experiments that were asked for: study run --part
  std::string target = {}, caches = {};  // as machine.h has them

  bool operator==(const Origin&) const = default;
};

struct StudyResults {
  Origin origin;
  std::vector<ExperimentResult> experiments;
};

}  // namespace glassbox::study
