// The law for every experiment: its errors are what the theory predicts, or a finding explains why
// not.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "study/experiments/experiments.h"
#include "tests/support/catch.h"

namespace glassbox::test {

struct Measured {
  study::Configuration configuration;
  double error = 0;
};

inline std::vector<Measured> measure(const study::Experiment& experiment) {
  std::vector<Measured> all;
  for (study::Configuration& configuration : experiment.configurations(study::Effort::kQuick)) {
    const double error = configuration.error();
    all.push_back({std::move(configuration), error});
  }
  return all;
}

inline std::string describe(const Measured& m) {
  const study::Configuration& c = m.configuration;
  std::string text = c.measure + " " + c.series + " at " + std::to_string(c.parameter) + ", " +
                     c.scene + ": measured " + std::to_string(m.error);
  if (c.predicted_error) text += ", predicted " + std::to_string(*c.predicted_error);
  return text;
}

// Whether the error is exactly 0 where 0 is predicted, and otherwise within a factor of two of the
// prediction or within the ratios that the finding states.
inline bool obeys_theory(const Measured& m) {
  const std::optional<double>& predicted = m.configuration.predicted_error;
  if (!predicted) return m.error >= 0;
  if (*predicted == 0) return m.error == 0;
  const bool near = m.error >= *predicted / 2 && m.error <= *predicted * 2;
  return near ||
         (m.configuration.finding && m.configuration.finding->explains(m.error / *predicted));
}

// Checks the law, and that a second run gives the same to the last digit. Returns the measurements.
inline std::vector<Measured> check_experiment(const study::Experiment& experiment) {
  const std::vector<Measured> first = measure(experiment), second = measure(experiment);
  REQUIRE(!first.empty());
  REQUIRE(first.size() == second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    INFO(experiment.id << ": " << describe(first[i]));
    CHECK(obeys_theory(first[i]));
    CHECK(first[i].error == second[i].error);
  }
  return first;
}

// The largest error of a series in one measure, on one scene or (if empty) on all scenes.
inline double largest_error(const std::vector<Measured>& all, const std::string& series,
                            const std::string& scene = "", const std::string& measure = "") {
  double largest = -1;
  for (const Measured& m : all) {
    if (m.configuration.series == series && m.configuration.measure == measure &&
        (scene.empty() || m.configuration.scene == scene))
      largest = std::max(largest, m.error);
  }
  INFO(series);
  REQUIRE(largest >= 0);  // the series exists
  return largest;
}

// The error of a series on a scene at one parameter.
inline double error_at(const std::vector<Measured>& all, const std::string& series,
                       const std::string& scene, double parameter,
                       const std::string& measure = "") {
  for (const Measured& m : all) {
    if (m.configuration.series == series && m.configuration.scene == scene &&
        m.configuration.measure == measure && m.configuration.parameter == parameter)
      return m.error;
  }
  FAIL("no " << series << " at " << parameter << " on " << scene);
  return 0;
}

}  // namespace glassbox::test
