// Stiffness as curves: error and bound over the one parameter that makes a problem hard, for
// several methods, and the parameter from which on a method is no longer usable.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glassbox::study {

struct SweepPoint {
  double parameter = 0;
  double error = 0;             // infinity: no answer
  std::optional<double> bound;  // none: the theory guarantees nothing there
};

// The curve of one method, for example "float", "24 bits" or "camera-relative".
struct SweepSeries {
  std::string name;
  bool ours = false;  // the method of the pipeline
  std::vector<SweepPoint> points = {};
  // The first parameter whose error is greater than the sweep tolerates; none if it never is.
  std::optional<double> failure_parameter = {};
};

struct Sweep {
  std::string name;      // for example "near-far", as the command expects it
  std::string title;     // for example "Far plane over near plane"
  std::string question;  // one sentence
  std::string axis, axis_unit = {};
  std::string error, error_unit = {};
  std::string reference;  // what the error is measured against
  std::string bound;      // formula of the bound, with its source
  std::string tolerance;  // in words: the error from which on a method fails
  std::function<std::vector<SweepSeries>()> series;
};

// All sweeps, in the order of their numbers.
const std::vector<Sweep>& sweeps();

// Whether all points are within their bounds. This must be true for every series that has bounds,
// because a bound holds for naive code too.
bool within_bounds(const SweepSeries& series);

// Sets `failure_parameter` to that of the first point with an error above the tolerance.
SweepSeries with_limit(SweepSeries series, double tolerance);

}  // namespace glassbox::study
