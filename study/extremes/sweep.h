// Stiffness as curves: error and bound against the one parameter that makes a problem hard, for each way of doing it, and
// the place from which a way is of no use any more.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glassbox::study {

struct SweepPoint {
  double parameter = 0;
  double error = 0;             // infinity: no answer
  std::optional<double> bound;  // none: the theory gives no guarantee there
};

// One way: "float", "24 bits", "camera-relative".
struct SweepSeries {
  std::string name;
  bool ours = false;  // what the pipeline does
  std::vector<SweepPoint> points = {};
  // The first parameter whose error is beyond what the sweep tolerates; none where it never is.
  std::optional<double> gives_up = {};
};

struct Sweep {
  std::string name;      // "near-far", as the command takes it
  std::string title;     // "Far plane over near plane"
  std::string question;  // one sentence
  std::string axis, axis_unit = {};
  std::string error, error_unit = {};
  std::string reference;  // against what
  std::string bound;      // its formula, with the source
  std::string tolerance;  // when a way gives up, in words
  std::function<std::vector<SweepSeries>()> series;
};

// In the order of the specification.
const std::vector<Sweep>& sweeps();

// Points within their bounds: of every series that has them, for a bound holds for naive code too.
bool within_bounds(const SweepSeries& series);

// Fills in `gives_up`: the first point, in the order given, whose error is above the tolerance.
SweepSeries with_limit(SweepSeries series, double tolerance);

}  // namespace glassbox::study
