// The results of a run of the study, as plain data in the form of the result file.
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
  Quartiles ns;       // per item
  int disturbed = 0;  // number of disturbed repetitions (see timing.h)
};

struct ConfigurationResult {
  std::string series;
  double parameter = 0;
  std::string scene, measure;
  double error = 0;
  std::optional<double> predicted_error;
  std::optional<Finding> explanation;  // why theory and measurement differ
  std::vector<Timing> timings;         // ascending by number of threads; empty if nothing is timed
};

struct ExperimentResult {
  // These fields have the same meaning as in Experiment.
  std::string id, name, question, axis, axis_unit;
  bool logarithmic_axis = true, axis_is_chosen = false;
  bool more_is_better = false;  // used for a measure, see Measure
  std::string error, error_unit, reference, theory, item;
  std::vector<Measure> measures;  // each with its axis filled in
  MachineState machine;           // state at the start of its timing
  std::vector<ConfigurationResult> configurations;
};

inline constexpr int kMaxParts = 1000;

// Where results come from. Errors can be compared between results of the same version, times only
// between results whose origins are the same in all fields.
struct Origin {
  std::string machine, compiler, flags, version;
  Effort effort = Effort::kQuick;
  int threads = 1;                       // the largest number of threads used
  int part = 1, parts = 1;               // which part of the chosen experiments (study run --part)
  std::string target = {}, caches = {};  // see machine.h

  bool operator==(const Origin&) const = default;
};

struct StudyResults {
  Origin origin;
  std::vector<ExperimentResult> experiments;
};

}  // namespace glassbox::study
