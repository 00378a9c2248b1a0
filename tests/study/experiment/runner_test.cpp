// The protocol by which experiments are run: rounds, threads, disturbed samples.
#include <tests/support/catch.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <sched.h>

#include <glassbox/base/processor_time.h>

#include "study/experiment/runner.h"
#include "study/experiment/timing.h"
#include "tests/study/experiment/sample_experiment.h"

namespace glassbox::study {
namespace {

using test::Calls;
using test::sample_experiment;

TEST_CASE(
    "an experiment's errors are computed once each, and its times are those of 11 repetitions or "
    "more") {
  Calls calls;
  const ExperimentResult result = run_experiment(sample_experiment("D-0", calls), {});
  CHECK(calls.configurations == 1);
  CHECK(calls.errors == 2);
  REQUIRE(result.configurations.size() == 2);
  CHECK(result.configurations[0].error == 1);
  CHECK(result.configurations[1].error == 0.25);
  for (const ConfigurationResult& each : result.configurations) {
    REQUIRE(each.timings.size() == 1);
    CHECK(each.timings[0].threads == 1);
    CHECK(each.timings[0].repetitions >= 11);
    CHECK(each.timings[0].ns.lower > 0);
    CHECK(each.timings[0].ns.lower <= each.timings[0].ns.median);
    CHECK(each.timings[0].ns.median <= each.timings[0].ns.upper);
  }
}

TEST_CASE("another measure of the same work has its times, and the experiment's axis") {
  Calls calls;
  Experiment experiment = sample_experiment("D-0", calls);
  experiment.measures = {{.name = "square", .error = "error squared", .error_unit = "px^2"}};
  experiment.configurations = [only = experiment.configurations](Effort effort) {
    std::vector<Configuration> all = only(effort);
    for (const double steps : {1.0, 4.0, 5.0})
      all.push_back(
          {.series = "halving", .parameter = steps, .measure = "square", .error = [steps] {
             return 1 / (steps * steps);
           }});
    return all;
  };
  const ExperimentResult result = run_experiment(experiment, {});
  REQUIRE(result.configurations.size() == 5);
  CHECK(result.measures.front().axis == "steps");
  for (const std::size_t i : {0u, 1u}) {
    const ConfigurationResult &own = result.configurations[i],
                              &other = result.configurations[i + 2];
    CHECK(other.measure == "square");
    REQUIRE(other.timings.size() == 1);
    CHECK(other.timings[0].ns.median == own.timings[0].ns.median);
  }
  CHECK(result.configurations[4].timings.empty());  // nothing can be timed there
}

TEST_CASE("one thread is timed first, then all, where the experiment has a use for them") {
  Calls calls;
  Experiment experiment = sample_experiment("D-0", calls);
  RunOptions options;
  options.threads = 3;
  CHECK(run_experiment(experiment, options).configurations[0].timings.size() == 1);
  experiment.threaded = true;
  calls.works.clear();
  const ExperimentResult result = run_experiment(experiment, options);
  for (const ConfigurationResult& each : result.configurations) {
    REQUIRE(each.timings.size() == 2);
    CHECK(each.timings[0].threads == 1);
    CHECK(each.timings[1].threads == 3);
  }
  const auto three = [](const std::string& call) { return call.ends_with("/3"); };
  const auto first_of_three = std::ranges::find_if(calls.works, three);
  CHECK(first_of_three != calls.works.begin());
  CHECK(std::all_of(first_of_three, calls.works.end(), three));
}

// Waits until the threads of previous cases sleep: their work is counted in the process's time.
void wait_until_idle() {
  using namespace std::chrono_literals;
  double worked = 1;
  for (int i = 0; i < 1000 && worked > 0.1; ++i) {
    const double before = processor_ms();
    std::this_thread::sleep_for(10ms);
    worked = processor_ms() - before;
  }
}

TEST_CASE("one thread's time is the processor's, and a sample that had to wait is disturbed") {
  using namespace std::chrono_literals;
  wait_until_idle();
  const auto sleeps = [] { std::this_thread::sleep_for(2ms); };
  const std::vector<Timed> timed = time_in_turn({{sleeps, 1, 1}, {sleeps, 1, 2}}, 3);
  REQUIRE(timed.size() == 2);
  // Nothing was computed, and every round was disturbed.
  CHECK(timed[0].ns.median < 1e6);
  CHECK(timed[0].disturbed == 3);
  // For several threads only the wall clock can be used.
  CHECK(timed[1].ns.lower >= 2e6);
}

void spin() {
  volatile double sum = 0;
  for (int i = 0; i < 400000; ++i) sum = sum + i;
}

// A reference that takes one second, but a little more than kMaxSlower times that in the named
// rounds.
std::function<double()> reference_slow_in(const std::set<int>& rounds) {
  return [rounds, round = 0]() mutable { return rounds.contains(round++) ? 1.01 * kMaxSlower : 1; };
}

TEST_CASE("a round in which the reference was slower is measured again, or flagged") {
  // Two threads that are reported never to yield, so that only the reference decides.
  const auto rounds_and_disturbed = [&](const std::set<int>& slow) {
    int calls = 0;
    const auto counted = [&] {
      ++calls;
      spin();
    };
    const Probes probes{reference_slow_in(slow), [] { return 0L; }};
    const Timed timed = time_in_turn({{counted, 1, 2}}, 4, probes).front();
    return std::pair{calls - 2, timed.disturbed};
  };
  CHECK(rounds_and_disturbed({}) == std::pair{4, 0});
  CHECK(rounds_and_disturbed({1, 3}) == std::pair{6, 0});
  CHECK(rounds_and_disturbed({1, 2, 3, 4, 5, 6}) == std::pair{8, 2});
  // The other rounds are compared with the first one.
  CHECK(rounds_and_disturbed({0}) == std::pair{4, 0});
}

TEST_CASE(
    "a sample of several threads one of which had to give way is measured again, or flagged") {
  // The probe is called before and after each sample.
  const auto disturbed_samples = [](const std::set<int>& samples) {
    int readings = 0;
    long switches = 0;
    const auto read = [&] {
      const int sample = readings / 2;
      if (readings++ % 2 == 1 && samples.contains(sample)) ++switches;
      return switches;
    };
    const Probes probes{[] { return 1.0; }, read};
    const Timed timed = time_in_turn({{spin, 1, 2}}, 3, probes).front();
    return std::pair{readings / 2, timed.disturbed};
  };
  CHECK(disturbed_samples({}) == std::pair{3, 0});
  CHECK(disturbed_samples({1}) == std::pair{4, 0});
  CHECK(disturbed_samples({1, 3, 4, 5}) == std::pair{6, 1});
}

TEST_CASE("two busy threads on one processor have to give way") {
  cpu_set_t before, one;
  REQUIRE(sched_getaffinity(0, sizeof before, &before) == 0);
  CPU_ZERO(&one);
  for (std::size_t cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu)
    if (CPU_ISSET(cpu, &before)) CPU_SET(cpu, &one);
  REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
  const long switches = involuntary_switches();
  {
    // A thread inherits the processors that it may use. Each runs for many time slices, which take
    // milliseconds.
    const auto busy = [] {
      const double start = processor_ms();
      while (processor_ms() - start < 200) spin();
    };
    std::jthread other(busy);
    busy();
  }
  CHECK(involuntary_switches() > switches);
  REQUIRE(sched_setaffinity(0, sizeof before, &before) == 0);
}

TEST_CASE("a configuration without work has an error and no time") {
  Calls calls;
  Experiment experiment = sample_experiment("D-0", calls);
  const auto timed = experiment.configurations;
  experiment.configurations = [timed](Effort effort) {
    auto all = timed(effort);
    all[0].work = nullptr;
    return all;
  };
  const ExperimentResult result = run_experiment(experiment, {});
  CHECK(result.configurations[0].timings.empty());
  CHECK(result.configurations[0].error == 1);
  CHECK(result.configurations[1].timings.size() == 1);
}

TEST_CASE("works are repeated in turn, each round beginning one further on") {
  std::vector<int> order;
  const auto work = [&order](int number) {
    return [&order, number] {
      order.push_back(number);
      volatile double sum = 0;
      for (int i = 0; i < 2000000; ++i) sum = sum + i;  // takes longer than kMinSample
    };
  };
  time_in_turn({{work(0)}, {work(1)}, {work(2)}}, 4);
  // The first six calls are before any clock runs: one for the caches and one to see how long the
  // work takes. There are more than four rounds only if the machine was busy.
  REQUIRE(order.size() >= 18);
  CHECK(std::vector(order.begin() + 6, order.begin() + 18) ==
        std::vector<int>{0, 1, 2, 1, 2, 0, 2, 0, 1, 0, 1, 2});
}

TEST_CASE("times are for one item, and a short work is called often enough to be timed") {
  int calls = 0;
  const auto times = time_in_turn({{[&calls] { ++calls; }, 1}}, 11);
  REQUIRE(times.size() == 1);
  CHECK(calls > 11 * 100);  // a call takes a few nanoseconds, kMinSample is 200 us
  const auto pair = time_in_turn({{spin, 1}, {spin, 1000}}, 11);
  // The work is the same, so the ratio is a thousand apart from disturbances of the machine.
  CHECK(pair[0].ns.median / pair[1].ns.median > 100);
}

TEST_CASE("experiments are found by their number in either case of letters") {
  Calls calls;
  const std::vector<Experiment> all{sample_experiment("D-1", calls),
                                    sample_experiment("D-12", calls)};
  CHECK(find_experiment(all, "d-12") == &all[1]);
  CHECK(find_experiment(all, "D-1") == &all[0]);
  CHECK(find_experiment(all, "D-2") == nullptr);
  CHECK(find_experiment(all, "") == nullptr);
}

}  // namespace
}  // namespace glassbox::study
