#include "labs/framework/shrink.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "labs/framework/batch.h"
#include "labs/framework/compare.h"

namespace glassbox::labs {

namespace {

using Made = std::vector<std::uint64_t>;  // the choices that make an input

// How many bytes of choices are given to one process. Linux allows 128 KiB for an argument.
constexpr std::size_t kArgumentBytes = 100'000;

// Whether one input is simpler than another: it has fewer choices, or smaller ones.
bool is_simpler(const Made& a, const Made& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

class Shrinker {
public:
  Shrinker(Runner& runner, const std::filesystem::path& program, const std::string& check,
           const Case& input, const FirstFailure& failure, const RunLimits& limits)
      : runner_(runner),
        program_(program),
        check_(check),
        inputs_(*input.generated),
        index_(failure.index),
        state_(failure.verdict == Verdict::kThrew   ? CaseAnswer::State::kThrew
               : failure.verdict == Verdict::kCrash ? CaseAnswer::State::kCrashed
                                                    : CaseAnswer::State::kAnswered),
        limits_(limits) {}

  // The number of the first input that the program does not answer.
  std::size_t first_unanswered() {
    std::size_t first = 0, end = std::size_t(inputs_.count);
    while (end - first > 1) {
      const std::size_t middle = first + (end - first) / 2;
      const CaseAnswer answer = run({first, middle});
      (answer.state == CaseAnswer::State::kAnswered ? first : end) = middle;
    }
    return first;
  }

  // The simplest input that is found, from one that fails.
  Made simplest(Made made) {
    while (runs_ < kMaxShrinkRuns) {
      const std::optional<Made> simpler = one_step(made);
      if (!simpler) break;
      made = *simpler;
    }
    return made;
  }

  CaseAnswer answer_alone(const Made& made) {
    CaseAnswer answer = run({0, 0, {made}});
    if (answer.state != CaseAnswer::State::kAnswered) return answer;
    const auto one = split_batch(answer.answer, 1);
    answer.answer = one ? (*one)[0] : Answer();
    return answer;
  }

  // Whether the answer fails as the first failure does.
  bool fails(const Made& made, const CaseAnswer& answer) const {
    if (answer.state != state_) return false;
    if (answer.state != CaseAnswer::State::kAnswered) return true;
    Choices choices(made);
    return !inputs_.is_right(choices, answer.answer);
  }

private:
  CaseAnswer run(const SomeInputs& some) {
    ++runs_;
    CaseAnswer answer = run_inputs(runner_, program_, check_, index_, some, limits_);
    // An input that takes so long would take as long in the next processes.
    if (answer.state == CaseAnswer::State::kTimeout) runs_ = kMaxShrinkRuns;
    return answer;
  }

  // A simpler input that fails, too.
  std::optional<Made> one_step(const Made& made) {
    std::vector<Made> candidates;
    for (std::size_t length = 16; length > 0; length /= 2) {
      for (std::size_t at = 0; at + length <= made.size(); at += length) {
        Made shorter = made;
        shorter.erase(shorter.begin() + std::ptrdiff_t(at),
                      shorter.begin() + std::ptrdiff_t(at + length));
        candidates.push_back(shorter);
      }
    }
    for (std::size_t at = 0; at < made.size(); ++at) {
      for (const std::uint64_t smaller : smaller_choices(made[at])) {
        candidates.push_back(made);
        candidates.back()[at] = smaller;
      }
    }
    const std::vector<Made> failing = failing_of(candidates);
    if (failing.empty()) return std::nullopt;
    const Made best = *std::min_element(failing.begin(), failing.end(), is_simpler);
    // Often all choices can be made smaller at once.
    const Made together = all_at_once(made, failing);
    if (is_simpler(together, best) && !failing_of({together}).empty()) return together;
    return best;
  }

  // Numbers below a choice, from 0 up. The step of 2^-k of the choice finds a limit as a binary
  // search does. Even and odd numbers are both tried, because Choices::integer makes numbers of one
  // sign of the even ones and numbers of the other sign of the odd ones.
  static std::vector<std::uint64_t> smaller_choices(std::uint64_t choice) {
    std::vector<std::uint64_t> smaller;
    if (choice == 0) return smaller;
    smaller.push_back(0);
    for (const int shift : {1, 2, 3, 5, 8, 12, 20, 32}) {
      const std::uint64_t step = choice >> shift;
      if (step == 0) break;
      smaller.push_back(choice - step);
      smaller.push_back(choice - step - (step < choice ? 1 : 0));
    }
    if (choice > 1) smaller.push_back(choice - 1);
    if (choice > 2) smaller.push_back(choice - 2);
    return smaller;
  }

  // Every choice as small as it is in any failing input of the same length.
  static Made all_at_once(const Made& made, const std::vector<Made>& failing) {
    Made least = made;
    for (const Made& each : failing) {
      if (each.size() != made.size()) continue;
      for (std::size_t i = 0; i < made.size(); ++i) least[i] = std::min(least[i], each[i]);
    }
    return least;
  }

  std::vector<Made> failing_of(const std::vector<Made>& candidates) {
    std::vector<Made> failing, some;
    std::size_t bytes = 0;
    const auto run_some = [&] {
      append_failing(some, failing);
      some.clear();
      bytes = 0;
    };
    for (const Made& each : candidates) {
      // 21 bytes: the longest number and a space
      const std::size_t size = 21 * each.size() + 1;
      if (bytes + size > kArgumentBytes) run_some();
      some.push_back(each);
      bytes += size;
    }
    run_some();
    return failing;
  }

  // One process answers all inputs. If it does not end well, each one gets a process of its own.
  void append_failing(const std::vector<Made>& some, std::vector<Made>& failing) {
    if (some.empty()) return;
    const CaseAnswer batch = run({0, 0, some});
    const auto answers = batch.state == CaseAnswer::State::kAnswered
                             ? split_batch(batch.answer, some.size())
                             : std::nullopt;
    for (std::size_t i = 0; i < some.size() && (answers || runs_ < kMaxShrinkRuns); ++i) {
      const CaseAnswer answer = answers
                                    ? CaseAnswer{CaseAnswer::State::kAnswered, (*answers)[i], ""}
                                    : answer_alone(some[i]);
      if (fails(some[i], answer)) failing.push_back(some[i]);
    }
  }

  Runner& runner_;
  const std::filesystem::path& program_;
  const std::string& check_;
  const GeneratedInputs& inputs_;
  std::size_t index_;
  CaseAnswer::State state_;
  const RunLimits& limits_;
  int runs_ = 0;
};

bool can_be_repeated(Verdict verdict) {
  return verdict == Verdict::kWrong || verdict == Verdict::kThrew || verdict == Verdict::kCrash;
}

}  // namespace

void shrink_failure(CheckResult& result, const std::vector<Case>& cases, Runner& runner,
                    const std::filesystem::path& program, const RunLimits& limits) {
  if (!result.first || !can_be_repeated(result.first->verdict)) return;
  const std::size_t index = result.first->index;
  const Case& input = cases[index];
  if (!input.generated) return;
  Shrinker shrinker(runner, program, result.name, input, *result.first, limits);
  const std::size_t wrong = result.first->wrong_inputs;
  Made made = result.first->choices.value_or(Made());
  if (result.first->verdict != Verdict::kWrong)
    made = choices_of(*input.generated, shrinker.first_unanswered());
  made = shrinker.simplest(made);
  const CaseAnswer answer = shrinker.answer_alone(made);
  if (!shrinker.fails(made, answer)) return;
  Choices choices(made);
  FirstFailure failure = judge_answer(input.generated->expect(choices), answer, index);
  if (failure.verdict == Verdict::kRight) return;
  const std::string where = failure.where;
  failure.where = input.where + ": the simplest generated input that was found";
  if (wrong > 0)
    failure.where += fmt::format("; {} of {} answers are wrong", wrong, input.generated->count);
  failure.choices = std::move(made);
  failure.wrong_inputs = wrong;
  result.verdict = failure.verdict;
  result.first = std::move(failure);
}

}  // namespace glassbox::labs
