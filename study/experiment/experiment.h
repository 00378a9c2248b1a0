// What an experiment is: ways to do the same work, each with its error against a reference and its time (SPEC D).
//
// An experiment is one file of study/experiments: it says what it asks, along which axis, and lists its
// configurations. Measuring, timing, comparing with the theory and printing are done for it (study/experiment).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glassbox::study {

// How much is measured: kQuick is a sample of kFull that takes a tenth of its time.
enum class Effort { kQuick, kFull };

// Why a measured error is not within a factor of two of the predicted one, and what the ratio of the two is for that reason: one
// outside of it is not explained.
struct Finding {
  std::string why;
  double least = 0, greatest = 0;  // measured over predicted

  bool explains(double ratio) const { return ratio >= least && ratio <= greatest; }
  friend bool operator==(const Finding&, const Finding&) = default;
};

// What an experiment measures besides its own error, or along another axis. Each measure has charts and a table of its own, in
// which its configurations compete.
struct Measure {
  std::string name;        // short: "overlap"
  std::string error;       // what is measured, as Experiment::error
  std::string error_unit;  // of it; not the experiment's
  std::string axis = {};   // empty: the experiment's, its unit and its scale
  std::string axis_unit = {};
  bool logarithmic_axis = true;
  bool more_is_better = false;  // than less, as with errors

  friend bool operator==(const Measure&, const Measure&) = default;
};

// One point of the chart.
struct Configuration {
  std::string series;      // what is compared: "float", "camera-relative float", "double"
  double parameter = 0;    // where on the experiment's axis
  std::string scene = {};  // on what it was measured, where that is not the same for all
  std::string measure =
      {};  // the name of one of Experiment::measures; empty: the experiment's own error

  // In the experiment's unit, against its reference. The same to the last digit in every run and on every machine.
  std::function<double()> error = {};
  // What the theory says `error` is; none where it says nothing. 0 says: exact.
  std::optional<double> predicted_error = {};
  // Where measured and predicted error differ, and that is understood. Stated before anything is measured.
  std::optional<Finding> finding = {};

  // What is timed, on this many threads; empty where only the error is of interest, and where a measure is of work that is timed for
  // another one: of the same series and scene, at the same place of the same axis, whose times it has then. One call does `items` of
  // the work, long enough to be timed (0.1 ms or more) and short enough to be repeated (100 ms or less).
  std::function<void(int threads)> work = {};
  double items = 1;
};

struct Experiment {
  std::string id;              // "D-4"
  std::string name;            // "Perspective: where the divide is done"
  std::string question;        // one sentence for a reader who has not seen the chart yet
  std::string axis;            // what `parameter` is: "w at the far end over w at the near end"
  std::string axis_unit = {};  // empty: a ratio or a number of things
  bool logarithmic_axis = true;
  std::string error;            // what is measured: "largest error of u along a span"
  std::string error_unit = {};  // "texel"; empty: a share or a ratio
  std::string reference;        // against what: "the exact rational value"
  std::string theory;           // the formula of `predicted_error`, with its source
  std::string item;             // what the time is per: "pixel", "vertex", "frame"
  // Whether `work` makes use of more than one thread.
  bool threaded = false;
  // Whether the axis is chosen by whoever draws (bits, steps) rather than given to him (distances, sizes): configurations
  // at all its places then compete with each other, and otherwise only those at the same place.
  bool axis_is_chosen = false;
  std::vector<Measure> measures = {};
  std::function<std::vector<Configuration>(Effort)> configurations;
};

// All of them, in the order of their numbers.
const std::vector<Experiment>& experiments();

}  // namespace glassbox::study
