// The worst of many measurements, each with a bound of its own.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "study/extremes/kit/extreme_case.h"

namespace glassbox::study {

// Keeps the measurement that uses up most of its bound. NaN is as wrong as can be.
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

// A number of wrong answers out of `all`: none is right.
inline Outcome wrong_of(int wrong, int all, const std::string& what) {
  return {double(wrong), 0, std::nullopt,
          std::to_string(wrong) + " of " + std::to_string(all) + " " + what};
}

}  // namespace glassbox::study
