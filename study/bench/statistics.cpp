#include "study/bench/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace glassbox::study {

namespace {

double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * double(sorted.size() - 1);
  const auto below = std::size_t(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - double(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Quartiles quartiles(std::vector<double> values) {
  std::ranges::sort(values);
  return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75),
          quantile(values, 0.125), quantile(values, 0.875)};
}

PowerLaw fit_power_law(std::span<const Sample> samples) {
  const double count = double(samples.size());
  double mean_x = 0, mean_y = 0;
  for (const Sample& sample : samples) {
    mean_x += std::log(sample.x) / count;
    mean_y += std::log(sample.y) / count;
  }
  double xx = 0, xy = 0;
  for (const Sample& sample : samples) {
    const double dx = std::log(sample.x) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(sample.y) - mean_y);
  }
  PowerLaw law;
  law.exponent = xy / xx;
  law.factor = std::exp(mean_y - law.exponent * mean_x);
  for (const Sample& sample : samples) {
    const double off = std::log(sample.y) - mean_y - law.exponent * (std::log(sample.x) - mean_x);
    law.squares += off * off;
  }
  return law;
}

std::optional<Bend> find_bend(std::span<const Sample> samples) {
  constexpr double kMinTurn = 0.1;
  std::optional<Bend> best;
  const auto left_by = [](const Bend& bend) { return bend.before.squares + bend.after.squares; };
  for (std::size_t i = kMinFitted - 1; i + kMinFitted <= samples.size(); ++i) {
    const Bend bend{samples[i].x, fit_power_law(samples.first(i + 1)),
                    fit_power_law(samples.subspan(i))};
    if (!best || left_by(bend) < left_by(*best)) best = bend;
  }
  if (!best) return std::nullopt;
  const bool turns = std::abs(best->after.exponent - best->before.exponent) >= kMinTurn;
  const bool explains = left_by(*best) <= fit_power_law(samples).squares / 2;
  return turns && explains ? best : std::nullopt;
}

}  // namespace glassbox::study
