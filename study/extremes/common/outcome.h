// The result of one function or engine in an extreme case, and how its error is measured.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace glassbox::study {

struct Outcome {
  // In the unit of the case, the worst of everything that the case tries; infinite for a NaN or no
  // answer.
  double error = 0;
  double bound = 0;                      // the right code's error is at most this; 0: exact
  std::optional<double> condition = {};  // the condition number there, if the case has one
  std::string summary = {};              // the result in one line: "12 of 500 pixels are wrong"

  bool passes() const { return error <= bound; }  // false for NaN
};

// The outcome with the larger error; the first one if the errors are equal.
inline Outcome worse_of(Outcome a, Outcome b) {
  return a.error >= b.error ? std::move(a) : std::move(b);
}

// An outcome that passes only if the error is 0.
inline Outcome must_be_zero(double error, std::string summary) {
  return {.error = error, .summary = std::move(summary)};
}

// An outcome with a number of wrong answers out of `all`; it passes only with none. `more` is added
// to the text.
inline Outcome wrong_count_outcome(int wrong, int all, const std::string& what,
                                   const std::string& more = {}) {
  return must_be_zero(wrong, fmt::format("{} of {} {}{}", wrong, all, what, more));
}

// Compares many errors with one bound: finds the largest one, and counts those beyond the bound. A
// NaN counts as infinite.
class ErrorsAboveBound {
public:
  explicit ErrorsAboveBound(double bound) : bound_(bound) {}

  void add(double error) {
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
    ++tried_;
    beyond_ += error > bound_;
    largest_ = std::max(largest_, error);
  }
  // The text of the outcome is for example "3 of 2,000 WHAT".
  Outcome outcome(const std::string& what) const {
    return {largest_, bound_, {}, fmt::format("{} of {} {}", beyond_, tried_, what)};
  }

private:
  double bound_, largest_ = 0;
  std::int64_t tried_ = 0, beyond_ = 0;
};

// Finds the worst of many measurements, each with its own bound: the error that is the largest
// fraction of its bound. A NaN counts as infinite.
class WorstError {
public:
  void add(double error, double bound, std::string where = {},
           std::optional<double> condition = std::nullopt) {
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
    ++count_;
    const double share = error <= 0 ? 0 : bound > 0 ? error / bound : kInfinity;
    const bool worse = share > share_ || (share == share_ && error > error_);
    if (count_ > 1 && !worse) return;
    share_ = share;
    error_ = error;
    bound_ = bound;
    where_ = std::move(where);
    condition_ = condition;
  }

  int count() const { return count_; }
  const std::string& where() const { return where_; }

  // `summary` is added to the text that describes the worst error.
  Outcome outcome(const std::string& summary = {}) const {
    Outcome outcome{error_, bound_, condition_, where_};
    if (!summary.empty()) outcome.summary += (outcome.summary.empty() ? "" : "; ") + summary;
    return outcome;
  }

private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  int count_ = 0;
  double share_ = 0, error_ = 0, bound_ = 0;
  std::string where_;
  std::optional<double> condition_;
};

}  // namespace glassbox::study
