#include "labs/framework/shrink.h"

#include <algorithm>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "labs/framework/batch.h"
#include "labs/framework/compare.h"

namespace glassbox::labs {

namespace {

using Made = std::vector<std::uint64_t>;  // the choices that make an input

// How many bytes of choices are given to one process. Linux allows 128 KiB for an argument. An
// input with more choices is not tried.
constexpr std::size_t kArgumentBytes = 100'000;

// The bytes of an input in the argument. 21: the longest number and a space.
std::size_t argument_bytes(const Made& made) {
  return 21 * made.size() + 1;
}

// Whether one input is simpler than another: it has fewer choices, or smaller ones.
bool is_simpler(const Made& a, const Made& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

// A change that makes an input simpler: `length` choices are removed, or, if that is 0, one of them
// becomes `value`.
struct Edit {
  std::size_t at = 0, length = 0;
  std::uint64_t value = 0;

  Made of(const Made& made) const {
    Made edited = made;
    if (length == 0) {
      edited[at] = value;
      return edited;
    }
    const auto first = edited.begin() + std::ptrdiff_t(at);
    edited.erase(first, first + std::ptrdiff_t(length));
    return edited;
  }
};

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
    while (end - first > 1 && may_run()) {
      const std::size_t middle = first + (end - first) / 2;
      const CaseAnswer answer = run({first, middle});
      (answer.state == CaseAnswer::State::kAnswered ? first : end) = middle;
    }
    return first;
  }

  // The simplest input that is found, from one that fails.
  Made simplest(Made made) {
    if (state_ != CaseAnswer::State::kAnswered) return simplest_unanswered(std::move(made));
    while (may_run()) {
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

  // Whether a process did not start, or reached a limit.
  bool was_stopped() const { return was_stopped_; }

private:
  // Called for an edit whose input fails. Returns whether that is enough.
  using Failing = std::function<bool(const Edit& edit, const Made& edited)>;

  bool may_run() const { return runs_ < kMaxShrinkRuns && !was_stopped_; }

  CaseAnswer run(const SomeInputs& some) {
    ++runs_;
    CaseAnswer answer = run_inputs(runner_, program_, check_, index_, some, limits_);
    using State = CaseAnswer::State;
    if (answer.state == State::kTimeout || answer.state == State::kLimit) was_stopped_ = true;
    return answer;
  }

  // A simpler input with a wrong answer, too.
  std::optional<Made> one_step(const Made& made) {
    std::optional<Made> best;
    Made together = made;  // every choice as small as in any failing input of the same length
    const auto note = [&](const Edit& edit, const Made& edited) {
      if (!best || is_simpler(edited, *best)) best = edited;
      if (edit.length == 0) together[edit.at] = std::min(together[edit.at], edit.value);
      return false;
    };
    visit_failing(made, edits_of(made, 0), note);
    // Often all choices can be made smaller at once.
    if (best && is_simpler(together, *best) && may_run() && !is_too_long(together) &&
        fails(together, answer_alone(together)))
      return together;
    return best;
  }

  // A process says nothing of the inputs behind the first one that it does not answer. So the first
  // edit that fails is taken, and then those from its place on are tried, until none fails.
  Made simplest_unanswered(Made made) {
    std::size_t place = 0;
    while (may_run()) {
      std::optional<Edit> found;
      visit_failing(made, edits_of(made, place), [&](const Edit& edit, const Made&) {
        found = edit;
        return true;
      });
      if (!found && place == 0) break;
      place = found && found->length == 0 ? found->at : 0;
      if (found) made = found->of(made);
    }
    return made;
  }

  // The edits that are tried, the simplest inputs first: without some choices, unless `place` is
  // not 0, and with a smaller choice from `place` on.
  std::vector<Edit> edits_of(const Made& made, std::size_t place) const {
    std::vector<Edit> edits;
    for (std::size_t length = place == 0 ? 16 : 0; length > 0; length /= 2) {
      for (std::size_t at = 0; at + length <= made.size(); at += length)
        edits.push_back({at, length});
    }
    for (std::size_t at = place; at < made.size(); ++at) {
      for (const std::uint64_t smaller : smaller_choices(made[at]))
        edits.push_back({at, 0, smaller});
    }
    return edits;
  }

  // Numbers below a choice, from 0 up. The step of 2^-k of the choice finds a limit as a binary
  // search does. Even and odd numbers are both tried, because Choices::integer makes numbers of one
  // sign of the even ones and numbers of the other sign of the odd ones. For a crash or an
  // exception, where only the first edit that fails is found, 2^-k of the choice is tried, too: so
  // it takes few edits to come near a limit.
  std::vector<std::uint64_t> smaller_choices(std::uint64_t choice) const {
    std::vector<std::uint64_t> smaller;
    if (choice == 0) return smaller;
    smaller.push_back(0);
    const auto add = [&](std::uint64_t below) {
      smaller.push_back(below);
      smaller.push_back(below - (below > 0 ? 1 : 0));
    };
    for (const int shift : {1, 2, 3, 5, 8, 12, 20, 32}) {
      const std::uint64_t step = choice >> shift;
      if (step == 0) break;
      add(choice - step);
      if (state_ != CaseAnswer::State::kAnswered) add(step);
    }
    if (choice > 1) smaller.push_back(choice - 1);
    if (choice > 2) smaller.push_back(choice - 2);
    std::sort(smaller.begin(), smaller.end());
    smaller.erase(std::unique(smaller.begin(), smaller.end()), smaller.end());
    return smaller;
  }

  static bool is_too_long(const Made& made) { return argument_bytes(made) > kArgumentBytes; }

  // Visits the edits whose inputs fail, in their order. Each process gets twice as many inputs as
  // the one before, as long as they fit into an argument.
  void visit_failing(const Made& made, const std::vector<Edit>& edits, const Failing& failing) {
    // The first failing edit is often among the first ones after a crash, and anywhere else.
    const bool is_first_enough = state_ != CaseAnswer::State::kAnswered;
    std::size_t most = is_first_enough ? 8 : edits.size();
    for (std::size_t begin = 0; begin < edits.size();) {
      std::vector<Made> some;
      std::size_t bytes = 0, end = begin;
      for (; end < edits.size() && end - begin < most; ++end) {
        Made edited = edits[end].of(made);
        const std::size_t own = argument_bytes(edited);
        if (end > begin && bytes + own > kArgumentBytes) break;
        bytes += own;
        some.push_back(std::move(edited));
      }
      if (visit_failing_of(&edits[begin], some, failing) || !may_run()) return;
      begin = end;
      most *= 2;
    }
  }

  // Visits those of the inputs `some`, made by as many edits, that fail. One process answers all
  // inputs. If it does not end well, each half gets a process of its own. Returns whether nothing
  // more is to be visited.
  bool visit_failing_of(const Edit* edits, const std::vector<Made>& some, const Failing& failing) {
    if (!may_run()) return true;
    if (some.size() == 1 && is_too_long(some[0])) return false;
    const CaseAnswer batch = run({0, 0, some});
    const bool is_answered = batch.state == CaseAnswer::State::kAnswered;
    const auto answers =
        is_answered ? split_batch(batch.answer, some.size()) : std::optional<std::vector<Answer>>();
    if (!answers && some.size() > 1) {
      const auto middle = some.begin() + std::ptrdiff_t(some.size() / 2);
      return visit_failing_of(edits, {some.begin(), middle}, failing) ||
             visit_failing_of(edits + some.size() / 2, {middle, some.end()}, failing);
    }
    for (std::size_t i = 0; i < some.size(); ++i) {
      const CaseAnswer answer =
          answers       ? CaseAnswer{CaseAnswer::State::kAnswered, (*answers)[i], ""}
          : is_answered ? CaseAnswer{CaseAnswer::State::kAnswered, Answer(), ""}
                        : batch;
      if (fails(some[i], answer) && failing(edits[i], some[i])) return true;
    }
    return false;
  }

  Runner& runner_;
  const std::filesystem::path& program_;
  const std::string& check_;
  const GeneratedInputs& inputs_;
  std::size_t index_;
  CaseAnswer::State state_;
  const RunLimits& limits_;
  int runs_ = 0;
  bool was_stopped_ = false;
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
  if (shrinker.was_stopped()) return;
  const CaseAnswer answer = shrinker.answer_alone(made);
  if (!shrinker.fails(made, answer)) return;
  Choices choices(made);
  FirstFailure failure = judge_answer(input.generated->expect(choices), answer, index);
  if (failure.verdict == Verdict::kRight) return;
  failure.where = input.where + ": the simplest generated input that was found";
  if (wrong > 0)
    failure.where += fmt::format("; {} of {} answers are wrong", wrong, input.generated->count);
  failure.choices = std::move(made);
  failure.wrong_inputs = wrong;
  result.verdict = failure.verdict;
  result.first = std::move(failure);
}

}  // namespace glassbox::labs
