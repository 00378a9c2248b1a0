#include "study/experiment/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace glassbox::study {

namespace {

double seconds_of(const std::function<void()>& work, int calls) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i) work();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return taken.count();
}

// After a first call, which pays for caches and pages.
int calls_a_sample(const std::function<void()>& work) {
  constexpr double kMostCalls = 100000;
  work();
  const double seconds = std::max(seconds_of(work, 1), 1e-9);
  return int(std::clamp(std::ceil(kLeastSample / seconds), 1.0, kMostCalls));
}

}  // namespace

std::vector<Quartiles> time_in_turn(const std::vector<TimedWork>& works, int repetitions) {
  std::vector<int> calls;
  for (const TimedWork& each : works) calls.push_back(calls_a_sample(each.work));
  std::vector<std::vector<double>> samples(works.size());
  for (std::size_t round = 0; round < std::size_t(repetitions); ++round) {
    for (std::size_t turn = 0; turn < works.size(); ++turn) {
      const std::size_t i = (round + turn) % works.size();
      const double seconds = seconds_of(works[i].work, calls[i]);
      samples[i].push_back(1e9 * seconds / (calls[i] * works[i].items));
    }
  }
  std::vector<Quartiles> all;
  for (std::vector<double>& each : samples) all.push_back(quartiles(std::move(each)));
  return all;
}

}  // namespace glassbox::study
