// Inputs that differ from student to student: another seed gives other inputs, and the solution
// answers all of them.
#include "labs/framework/varied_inputs.h"

#include "labs/framework/lab.h"
#include "tests/labs/framework/bench.h"
#include "tests/support/catch.h"
#include "tests/support/daily_share.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

// Sets the seed of the inputs in the tests' process, and resets it to 0 at the end.
struct ScopedInputsSeed {
  explicit ScopedInputsSeed(std::uint64_t seed) { set_inputs_seed(seed); }
  ~ScopedInputsSeed() { set_inputs_seed(0); }
};

// Returns everything that a lab's hidden checks, or its visible ones, ask and expect.
std::string asked(const Lab& lab, bool hidden) {
  std::string text;
  for (const Check& check : lab.checks) {
    if (check.hidden != hidden) continue;
    for (const Case& each : check.cases()) {
      text += check.name + ": " + each.where + "; " + each.restated;
      for (const Expected& expected : each.expected) {
        for (const double value : expected.values) text += fmt::format(" {}", value);
      }
      text += "\n";
    }
  }
  return text;
}
std::string asked(const Lab& lab, bool hidden, std::uint64_t seed) {
  const ScopedInputsSeed seeded(seed);
  return asked(lab, hidden);
}

}  // namespace

TEST_CASE("a seed changes what every lab's hidden checks ask, and nothing that students have") {
  for (const Lab& lab : all_labs()) {
    INFO(lab.folder);
    CHECK(asked(lab, true, 1) == asked(lab, true, 1));
    CHECK(asked(lab, true, 1) != asked(lab, true, 2));
    CHECK(asked(lab, true, 1) != asked(lab, true, 0));
    CHECK(asked(lab, false, 1) == asked(lab, false, 0));
  }
}

namespace {

// Checks the solutions with 50 seeds of the inputs, or with the share's part of them.
void answer_seeds(const test::DailyShare& share) {
  constexpr std::size_t kSeeds = 50;
  for (const Lab& lab : all_labs()) {
    Bench& bench = Bench::for_lab(lab);
    const BenchProgram program = bench.program(bench.solution());
    // Generated inputs are so many that one seed of them is enough.
    Inputs inputs = Inputs::kAll;
    for (std::size_t seed = 1; seed <= kSeeds; ++seed) {
      if (!share.includes(seed - 1, kSeeds)) continue;
      const ScopedInputsSeed seeded(seed);
      const auto result = bench.check_with_new_cases(program, inputs);
      inputs = Inputs::kCases;
      INFO(lab.folder << ", seed " << seed << " of the inputs, " << share.text() << "\n"
                      << failures(result));
      CHECK(result.score == result.max_score);
    }
  }
}

}  // namespace

TEST_CASE("every solution has all points under seeds of its inputs, a few every day") {
  answer_seeds(test::DailyShare(10));
}

TEST_CASE("every solution has all points under 50 seeds of its inputs", "[.faults]") {
  answer_seeds(test::DailyShare::everything());
}
