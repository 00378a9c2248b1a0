// Conclusions from errors and times: the comparison with the theory, and the Pareto front.
#include <tests/support/catch.h>

#include <cmath>
#include <limits>
#include <vector>

#include "study/experiment/measures.h"
#include "study/experiment/pareto.h"
#include "study/experiment/theory.h"
#include "tests/study/experiment/sample_experiment.h"

namespace glassbox::study {
namespace {

using test::result_of;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNaN = std::nan("");

ConfigurationResult compared(double error, double predicted) {
  ConfigurationResult result = result_of(1, error, 10);
  result.predicted_error = predicted;
  return result;
}

TEST_CASE("an error within a factor of two of the theory is as predicted, both ends included") {
  for (const double error : {0.5, 0.7, 1.0, 1.9, 2.0}) {
    INFO(error);
    CHECK(check_theory(compared(error, 1))->ratio == error);
    CHECK_FALSE(check_theory(compared(error, 1))->finding);
  }
  for (const double error :
       {0.0, std::nextafter(0.5, 0), std::nextafter(2, 3), 100.0, kInfinity, kNaN}) {
    INFO(error);
    CHECK(check_theory(compared(error, 1))->finding);
  }
}

TEST_CASE("an error of 0 where 0 is predicted is as predicted, and any other one is a finding") {
  CHECK(check_theory(compared(0, 0))->ratio == 1);
  CHECK_FALSE(check_theory(compared(0, 0))->finding);
  CHECK(check_theory(compared(1e-300, 0))->ratio == kInfinity);
  CHECK(check_theory(compared(1e-300, 0))->finding);
  CHECK_FALSE(check_theory(compared(kInfinity, kInfinity))->finding);
}

TEST_CASE("without a prediction nothing is compared") {
  CHECK_FALSE(check_theory(result_of(1, 5, 10)).has_value());
  CHECK_FALSE(is_unexplained(result_of(1, 5, 10)));
}

TEST_CASE("findings are counted, and those without an explanation apart") {
  ExperimentResult result;
  result.configurations = {compared(1, 1), compared(5, 1), compared(9, 1)};
  CHECK(count_findings(result) == 2);
  CHECK(count_unexplained(result) == 2);
  result.configurations[2].explanation = Finding{"the bound is loose there", 5, 10};
  result.configurations[0].explanation = Finding{"not needed", 1, 2};
  CHECK(count_findings(result) == 2);
  CHECK(count_unexplained(result) == 1);
  // An explanation holds only for the ratios that it states: a larger or smaller ratio is
  // unexplained.
  result.configurations[2].error = 11;
  CHECK(count_unexplained(result) == 2);
  result.configurations[2].error = 4.5;
  CHECK(count_unexplained(result) == 2);
  result.configurations[2].error = std::numeric_limits<double>::quiet_NaN();
  CHECK(count_unexplained(result) == 2);
}

std::vector<Standing> standings_of(std::vector<ConfigurationResult> configurations, bool chosen) {
  ExperimentResult result;
  result.axis_is_chosen = chosen;
  result.configurations = std::move(configurations);
  return standings(result);
}

constexpr Standing kFront = Standing::kFront, kDominated = Standing::kDominated;

TEST_CASE(
    "a configuration is dominated where another one is as accurate or more, and faster for "
    "certain") {
  CHECK(standings_of({result_of(1, 1, 10), result_of(1, 2, 5), result_of(1, 3, 7)}, false) ==
        std::vector{kFront, kFront, kDominated});
  CHECK(standings_of({result_of(1, 1, 10), result_of(1, 2, 11)}, false) ==
        std::vector{kFront, kDominated});
  CHECK(standings_of({result_of(1, 1, 10), result_of(1, 1, 12)}, false) ==
        std::vector{kFront, kDominated});
}

TEST_CASE("times whose middle three quarters overlap order nothing, whatever the errors") {
  // The quartiles do not overlap, but the octiles do.
  ConfigurationResult fast = result_of(1, 1, 10, 2), slow = result_of(1, 2, 15, 2);
  slow.timings.front().ns.first_octile = 11;
  CHECK(standings_of({fast, slow}, false) == std::vector{kFront, kFront});

  CHECK(standings_of({result_of(1, 1, 10), result_of(1, 2, 10)}, false) ==
        std::vector{kFront, kFront});
  CHECK(standings_of({result_of(1, 1, 10, 2), result_of(1, 2, 13, 2)}, false) ==
        std::vector{kFront, kFront});
  CHECK(standings_of({result_of(1, 1, 10, 2), result_of(1, 2, 15, 2)}, false) ==
        std::vector{kFront, kDominated});

  CHECK(standings_of({result_of(1, 0, 10, 2), result_of(1, 0, 11, 2)}, false) ==
        std::vector{kFront, kFront});
  CHECK(standings_of({result_of(1, 0, 10, 2), result_of(1, 0, 15, 2)}, false) ==
        std::vector{kFront, kDominated});
}

TEST_CASE("places of an axis compete only where the axis is chosen, and scenes never") {
  const std::vector<ConfigurationResult> apart{result_of(1, 1, 10), result_of(2, 5, 20)};
  CHECK(standings_of(apart, false) == std::vector{kFront, kFront});
  CHECK(standings_of(apart, true) == std::vector{kFront, kDominated});
  std::vector<ConfigurationResult> scenes{result_of(1, 1, 10), result_of(1, 5, 20)};
  scenes[1].scene = "another";
  CHECK(standings_of(scenes, true) == std::vector{kFront, kFront});
}

TEST_CASE("measures do not compete with each other, and each knows whether more is better") {
  ExperimentResult result;
  result.measures = {
      {.name = "signal", .error = "signal over noise", .error_unit = "dB", .more_is_better = true}};
  result.configurations = {result_of(1, 1, 10), result_of(1, 2, 20), result_of(1, 30, 10),
                           result_of(1, 20, 20), result_of(1, 40, 20)};
  for (std::size_t i = 2; i < 5; ++i) result.configurations[i].measure = "signal";
  CHECK(standings(result) == std::vector{kFront, kDominated, kFront, kDominated, kFront});
  const std::vector<ExperimentResult> parts = by_measure(result);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].configurations.size() == 2);
  CHECK(parts[1].configurations.size() == 3);
  CHECK(parts[1].error_unit == "dB");
  CHECK(standings(parts[1]) == std::vector{kFront, kDominated, kFront});
}

TEST_CASE(
    "what has no time stands nowhere, and what has no answer is dominated by any that has one") {
  ConfigurationResult untimed = result_of(1, 0, 1);
  untimed.timings.clear();
  CHECK(standings_of({untimed, result_of(1, 1, 10)}, true) ==
        std::vector{Standing::kUntimed, kFront});
  CHECK(standings_of({result_of(1, kNaN, 10), result_of(1, 100, 10)}, true) ==
        std::vector{kDominated, kFront});
  CHECK(standings_of({result_of(1, kInfinity, 5), result_of(1, 100, 10)}, true) ==
        std::vector{kFront, kFront});
}

TEST_CASE("each number of threads has a front of its own") {
  ExperimentResult result;
  result.configurations = {result_of(1, 1, 10), result_of(1, 1, 20)};
  result.configurations[0].timings.push_back({2, 11, {9, 9, 9, 9, 9}, 0});
  result.configurations[1].timings.push_back({2, 11, {4, 4, 4, 4, 4}, 0});
  CHECK(thread_counts(result) == std::vector{1, 2});
  CHECK(standings(result, 1) == std::vector{kFront, kDominated});
  CHECK(standings(result, 2) == std::vector{kDominated, kFront});
  CHECK(standings(result, 3) == std::vector{Standing::kUntimed, Standing::kUntimed});
}

}  // namespace
}  // namespace glassbox::study
