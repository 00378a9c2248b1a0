#include "study/experiment/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>

namespace glassbox::study {

namespace {

struct Seconds {
  double wall = 0, processor = 0;
};

// Measures the processor time of the whole process, because work may be done by another thread
// while the thread that calls it waits.
Seconds seconds_of(const std::function<void()>& work, int calls) {
  const double processor = processor_ms();  // read before the wall clock, because it takes longer
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i) work();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return {taken.count(), 1e-3 * (processor_ms() - processor)};
}

// Makes a first call, which is not counted, to fill the caches and memory pages; then estimates how
// many calls one sample needs.
int calls_a_sample(const std::function<void()>& work) {
  constexpr double kMaxCalls = 100000;
  work();
  const double seconds = std::max(seconds_of(work, 1).wall, 1e-9);
  return int(std::clamp(std::ceil(kMinSample / seconds), 1.0, kMaxCalls));
}

// Tells whether the processor is slower than at its best so far, by timing a fixed piece of work.
class Reference {
public:
  explicit Reference(const std::function<double()>& seconds) : seconds_(seconds) {}

  bool is_slower() {
    const double seconds = seconds_();
    least_ = std::min(least_, seconds);
    return seconds > kMaxSlower * least_;
  }

private:
  const std::function<double()>& seconds_;
  double least_ = std::numeric_limits<double>::infinity();
};

// The times of one work, in nanoseconds per item.
struct Samples {
  std::vector<double> steady, disturbed;

  // Returns the statistics of `wanted` samples. Disturbed samples are added if there are not enough
  // undisturbed ones.
  Timed finish(std::size_t wanted) {
    const std::size_t missing =
        std::min(wanted - std::min(wanted, steady.size()), disturbed.size());
    steady.insert(steady.end(), disturbed.begin(), disturbed.begin() + std::ptrdiff_t(missing));
    return {quartiles(std::move(steady)), int(missing)};
  }
};

}  // namespace

double seconds_of_products() {
  volatile float result = 2;
  return seconds_of(
             [&result] {
               float x = result;
               for (int i = 0; i < 100000; ++i) x = x * 0.999f + 0.001f;
               result = x;
             },
             1)
      .processor;
}

std::vector<Timed> time_in_turn(const std::vector<TimedWork>& works, int repetitions,
                                const Probes& probes) {
  std::vector<int> calls;
  for (const TimedWork& each : works) calls.push_back(calls_a_sample(each.work));
  const auto wanted = std::size_t(repetitions);
  std::vector<Samples> samples(works.size());
  const auto is_done = [&](const Samples& of) { return of.steady.size() >= wanted; };
  Reference reference(probes.reference_seconds);
  for (std::size_t round = 0; round < 2 * wanted; ++round) {
    if (std::ranges::all_of(samples, is_done)) break;
    const bool slower = reference.is_slower();
    for (std::size_t turn = 0; turn < works.size(); ++turn) {
      const std::size_t i = (round + turn) % works.size();
      if (is_done(samples[i])) continue;
      const long switches = probes.switches();
      const Seconds taken = seconds_of(works[i].work, calls[i]);
      const bool alone = works[i].threads == 1;
      const bool waited =
          alone ? taken.wall > (1 + kMaxWaiting) * taken.processor : probes.switches() != switches;
      const double seconds = alone ? taken.processor : taken.wall;
      (slower || waited ? samples[i].disturbed : samples[i].steady)
          .push_back(1e9 * seconds / (calls[i] * works[i].items));
    }
  }
  std::vector<Timed> all;
  for (Samples& each : samples) all.push_back(each.finish(wanted));
  return all;
}

}  // namespace glassbox::study
