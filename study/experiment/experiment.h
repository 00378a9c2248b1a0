// An experiment: several ways to do the same work, each with its error against a reference and its
// time.
//
// Each experiment is one file in study/experiments: it states its question and its axis, and lists
// its configurations. The files in study/experiment do the rest: they measure, time, compare with
// the theory and print.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glassbox::study {

// How much is measured: kQuick measures a part of what kFull measures, in a tenth of the time.
enum class Effort { kQuick, kFull };

// The reason why a measured error differs from the predicted one by more than a factor of two. It
// is valid for ratios from `least` to `greatest`; a ratio outside this range is not explained.
struct Finding {
  std::string why;
  double least = 0, greatest = 0;  // range of measured / predicted

  bool explains(double ratio) const { return ratio >= least && ratio <= greatest; }
  friend bool operator==(const Finding&, const Finding&) = default;
};

// A quantity that an experiment measures in addition to its own error, or along another axis. Each
// measure has its own charts and table, in which its configurations compete.
struct Measure {
  std::string name;        // short, for example "overlap"
  std::string error;       // what is measured, like Experiment::error
  std::string error_unit;  // the unit of this measure, not the experiment's
  std::string axis = {};   // empty: axis, unit and scale of the experiment
  std::string axis_unit = {};
  bool logarithmic_axis = true;
  bool more_is_better = false;  // false: less is better, as with errors

  friend bool operator==(const Measure&, const Measure&) = default;
};

// One point of a chart.
struct Configuration {
  std::string series;      // what is compared: "float", "camera-relative float", "double"
  double parameter = 0;    // its place on the experiment's axis
  std::string scene = {};  // the scene of the measurement, if it is not the same for all
  // the name of one of Experiment::measures; empty: the experiment's own error
  std::string measure = {};

  // Computes the error against the reference, in the experiment's unit. It is the same to the last
  // digit in every run and on every machine.
  std::function<double()> error = {};
  // The value that the theory predicts for `error`; none if it predicts nothing, 0 if the result is
  // exact.
  std::optional<double> predicted_error = {};
  // The reason why measured and predicted error differ, if it is understood. It is stated before
  // anything is measured.
  std::optional<Finding> finding = {};

  // The work that is timed, on this number of threads. Empty if only the error matters, or if
  // another configuration with the same series, the same scene and the same place on the same axis
  // times the same work: then its times are used. One call does `items` units of work; it should
  // take between 0.1 ms, to be measurable, and 100 ms, to be repeated.
  std::function<void(int threads)> work = {};
  double items = 1;
};

struct Experiment {
  std::string id;              // for example "D-4"
  std::string name;            // for example "Perspective: where the divide is done"
  std::string question;        // one sentence for a reader who has not seen the chart yet
  std::string axis;            // what `parameter` is: "w at the far end over w at the near end"
  std::string axis_unit = {};  // empty: a ratio or a count
  bool logarithmic_axis = true;
  std::string error;            // what is measured: "largest error of u along a span"
  std::string error_unit = {};  // "texel"; empty: a fraction or a ratio
  std::string reference;        // what the error is measured against: "the exact rational value"
  std::string theory;           // the formula of `predicted_error`, with its source
  std::string item;             // what the time is divided by: "pixel", "vertex", "frame"
  // Whether `work` can use more than one thread.
  bool threaded = false;
  // Whether the user chooses the value on the axis (bits, steps) or it is given (distances, sizes).
  // If it is chosen, all configurations compete with each other; if not, only those with the same
  // value do.
  bool axis_is_chosen = false;
  std::vector<Measure> measures = {};
  std::function<std::vector<Configuration>(Effort)> configurations;
};

// All experiments, in the order of their numbers.
const std::vector<Experiment>& experiments();

}  // namespace glassbox::study
