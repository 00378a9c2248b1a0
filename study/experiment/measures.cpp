#include "study/experiment/measures.h"

#include <string>
#include <utility>

namespace glassbox::study {

namespace {

ExperimentResult described_by(const ExperimentResult& experiment, const Measure& measure) {
  ExperimentResult part = experiment;
  part.error = measure.error;
  part.error_unit = measure.error_unit;
  part.axis = measure.axis;
  part.axis_unit = measure.axis_unit;
  part.logarithmic_axis = measure.logarithmic_axis;
  part.more_is_better = measure.more_is_better;
  return part;
}

}  // namespace

std::vector<ExperimentResult> by_measure(const ExperimentResult& experiment) {
  std::vector<ExperimentResult> all;
  const auto add = [&](ExperimentResult part, const std::string& name) {
    std::erase_if(part.configurations,
                  [&](const ConfigurationResult& each) { return each.measure != name; });
    part.measures.clear();
    if (!part.configurations.empty()) all.push_back(std::move(part));
  };
  add(experiment, "");
  for (const Measure& measure : experiment.measures)
    add(described_by(experiment, measure), measure.name);
  return all;
}

}  // namespace glassbox::study
