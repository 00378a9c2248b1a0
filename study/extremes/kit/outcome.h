// What comes of putting a subject to a case, and how it is measured.
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
  // In the case's unit, worst over all that the case tries; infinity for a NaN or no answer.
  double error = 0;
  double bound = 0;                      // what the right code stays within; 0: exact
  std::optional<double> condition = {};  // the condition number there, where the case has one
  std::string seen = {};  // what came out, in one line: "18 gaps, 12 doubles of 2,600,000 samples"

  bool passes() const { return error <= bound; }  // false for NaN
};

// The outcome with the larger error, the first of equals.
inline Outcome worse_of(Outcome a, Outcome b) {
  return a.error >= b.error ? std::move(a) : std::move(b);
}

// An error of which nothing is right but 0.
inline Outcome must_be_zero(double error, std::string seen) {
  return {.error = error, .seen = std::move(seen)};
}

// A number of wrong answers out of `all`: none is right. `more` is added to what is seen.
inline Outcome wrong_of(int wrong, int all, const std::string& what, const std::string& more = {}) {
  return must_be_zero(wrong, fmt::format("{} of {} {}{}", wrong, all, what, more));
}

// Many errors against one bound: the largest, and how many are beyond it. NaN is as wrong as can be.
class ErrorsBeyond {
public:
  explicit ErrorsBeyond(double bound) : bound_(bound) {}

  void see(double error) {
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
    ++tried_;
    beyond_ += error > bound_;
    largest_ = std::max(largest_, error);
  }
  // "3 of 2,000 WHAT"
  Outcome outcome(const std::string& what) const {
    return {largest_, bound_, {}, fmt::format("{} of {} {}", beyond_, tried_, what)};
  }

private:
  double bound_, largest_ = 0;
  std::int64_t tried_ = 0, beyond_ = 0;
};

// The worst of many measurements, each with a bound of its own: the one that uses up most of it. NaN is as wrong as can be.
class Worst {
public:
  void see(double error, double bound, std::string where = {},
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

  // `seen` is added to where the worst was.
  Outcome outcome(const std::string& seen = {}) const {
    Outcome outcome{error_, bound_, condition_, where_};
    if (!seen.empty()) outcome.seen += (outcome.seen.empty() ? "" : "; ") + seen;
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
