// The generated inputs of every lab: what judges them quickly says the same as their cases.
#include <cmath>
#include <limits>
#include <set>

#include "labs/framework/batch.h"
#include "labs/framework/compare.h"
#include "labs/framework/run_check.h"
#include "tests/labs/framework/bench.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

// The answer with one change in one of its fields, or without one of them, or without all.
std::vector<Answer> changed(const Answer& answer) {
  std::vector<Answer> all{Answer()};
  const auto with = [&](std::size_t field, std::vector<double> values) {
    Answer other;
    for (std::size_t i = 0; i < answer.fields().size(); ++i)
      other.emit(answer.fields()[i].name, i == field ? values : answer.fields()[i].values);
    all.push_back(other);
  };
  for (std::size_t f = 0; f < answer.fields().size(); ++f) {
    const std::vector<double>& values = answer.fields()[f].values;
    Answer without;
    for (std::size_t i = 0; i < answer.fields().size(); ++i) {
      if (i != f) without.emit(answer.fields()[i].name, answer.fields()[i].values);
    }
    all.push_back(without);
    with(f, {});
    std::vector<double> longer = values;
    longer.push_back(1);
    with(f, longer);
    if (values.empty()) continue;
    with(f, {values.begin(), values.end() - 1});
    for (const std::size_t at : {std::size_t(0), values.size() - 1}) {
      for (const double other :
           {values[at] + 1, -values[at], std::nextafter(values[at], HUGE_VAL), values[at] * 2,
            std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
        std::vector<double> wrong = values;
        wrong[at] = other;
        with(f, wrong);
      }
    }
  }
  return all;
}

}  // namespace

TEST_CASE("the quick judge of generated inputs says what judging their cases says") {
  LocalRunner runner;
  RunLimits limits;
  limits.seconds = 60;  // enough for a machine that is compiling at the same time
  for (const Lab& lab : all_labs()) {
    Bench& bench = Bench::for_lab(lab);
    const BenchProgram program = bench.program(bench.solution());
    for (const Check& check : lab.checks) {
      if (!check.generated) continue;
      const std::vector<Case> cases = check.cases();
      for (std::size_t k = 0; k < cases.size(); ++k) {
        INFO(lab.folder << ", " << check.name << ", " << cases[k].where);
        const GeneratedInputs& inputs = *cases[k].generated;
        const auto count = std::size_t(std::min(inputs.count, 60));
        const CaseAnswer batch =
            run_inputs(runner, program.path, check.name, k, {0, count}, limits);
        REQUIRE(batch.state == CaseAnswer::State::kAnswered);
        const auto answers = split_batch(batch.answer, count);
        REQUIRE(answers);
        for (std::size_t i = 0; i < count; ++i) {
          const std::vector<std::uint64_t> made = choices_of(inputs, i);
          Choices of_case(made);
          const Case input = inputs.expect(of_case);
          const auto agrees = [&](const Answer& answer) {
            Choices choices(made);
            return inputs.is_right(choices, answer) == !judge_case(input, answer);
          };
          INFO("input " << i);
          CHECK(agrees((*answers)[i]));
          for (const Answer& other : changed((*answers)[i])) CHECK(agrees(other));
        }
      }
    }
  }
}

TEST_CASE("every function of every lab is held against generated inputs") {
  for (const Lab& lab : all_labs()) {
    std::set<std::string> tasks;
    for (const Check& check : lab.checks) {
      if (check.generated) tasks.insert(check.task);
    }
    for (const Task& task : lab.tasks) {
      INFO("task " << task.id);
      CHECK(tasks.count(task.id) == 1);
    }
  }
}
