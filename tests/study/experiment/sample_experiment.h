// An experiment with known errors, and results made by hand.
#pragma once

#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "study/experiment/experiment.h"
#include "study/experiment/results.h"

namespace glassbox::test {

// How often the functions of a sample experiment were called.
struct Calls {
  int configurations = 0, errors = 0;
  std::vector<std::string> works;  // in order: "1/2" is parameter 1 with two threads
};

// Errors 1 and 1/4 at parameters 1 and 4, predicted as 1/parameter, each timed.
inline study::Experiment sample_experiment(std::string id, Calls& calls) {
  study::Experiment experiment;
  experiment.id = std::move(id);
  experiment.name = "A sample";
  experiment.question = "Is it run?";
  experiment.axis = "steps";
  experiment.error = "error";
  experiment.error_unit = "px";
  experiment.reference = "arithmetic";
  experiment.theory = "1/steps";
  experiment.item = "call";
  experiment.configurations = [&calls](study::Effort) {
    ++calls.configurations;
    std::vector<study::Configuration> all;
    for (const double steps : {1.0, 4.0}) {
      study::Configuration each;
      each.series = "halving";
      each.parameter = steps;
      each.error = [&calls, steps] { return ++calls.errors, 1 / steps; };
      each.predicted_error = 1 / steps;
      each.work = [&calls, steps](int threads) {
        calls.works.push_back(std::to_string(int(steps)) + "/" + std::to_string(threads));
        // Long enough for a sample of a single call.
        volatile double sum = 0;
        for (int i = 0; i < 400000; ++i) sum = sum + i;
      };
      all.push_back(std::move(each));
    }
    return all;
  };
  return experiment;
}

inline study::ConfigurationResult result_of(double parameter, double error, double ns,
                                            double spread = 0) {
  study::ConfigurationResult result;
  result.series = "made by hand";
  result.parameter = parameter;
  result.error = error;
  result.timings = {{1, 11, {ns - spread, ns, ns + spread, ns - spread, ns + spread}, 0}};
  return result;
}

}  // namespace glassbox::test
