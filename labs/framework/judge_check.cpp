#include "labs/framework/judge_check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "labs/framework/batch.h"
#include "labs/framework/slips.h"

namespace glassbox::labs {

namespace {

Verdict verdict_of(CaseAnswer::State state) {
  switch (state) {
    case CaseAnswer::State::kMissing:
      return Verdict::kMissing;
    case CaseAnswer::State::kThrew:
      return Verdict::kThrew;
    case CaseAnswer::State::kCrashed:
      return Verdict::kCrash;
    case CaseAnswer::State::kTimeout:
      return Verdict::kTimeout;
    case CaseAnswer::State::kLimit:
      return Verdict::kLimit;
    case CaseAnswer::State::kMalformed:
      return Verdict::kMalformed;
    case CaseAnswer::State::kAnswered:
      break;
  }
  return Verdict::kRight;
}

// Adds the expected and the actual numbers of the wrong field, from which a report makes its
// pictures and map.
void add_field(const Case& input, const Answer& answer, FirstFailure& failure) {
  if (!failure.divergence) return;
  const auto* actual = find_field(answer, failure.divergence->field);
  if (actual != nullptr) failure.actual = *actual;
  for (const Expected& expected : input.expected) {
    if (expected.field != failure.divergence->field) continue;
    failure.expected = expected;
    if (!input.judge && actual != nullptr) failure.comparison = compare(expected, *actual);
  }
}

// Judges a class of generated inputs. The failure is that of the first input with a wrong answer.
FirstFailure judge_class(const Case& input, const Answer& batch, std::size_t index) {
  const GeneratedInputs& inputs = *input.generated;
  FirstFailure failure;
  failure.index = index;
  const auto answers = split_batch(batch, std::size_t(inputs.count));
  if (!answers) {
    failure.verdict = Verdict::kMalformed;
    failure.where = input.where;
    failure.text = fmt::format("these are not the answers to {} inputs", inputs.count);
    return failure;
  }
  const std::vector<std::size_t> wrong = wrong_inputs(inputs, *answers);
  if (wrong.empty()) {
    failure.verdict = Verdict::kRight;
    return failure;
  }
  Choices choices(choices_of(inputs, wrong[0]));
  const CaseAnswer answer{CaseAnswer::State::kAnswered, (*answers)[wrong[0]], ""};
  failure = judge_answer(inputs.expect(choices), answer, index);
  failure.verdict = Verdict::kWrong;
  failure.choices = choices.made();
  failure.wrong_inputs = wrong.size();
  failure.where = fmt::format("{}: generated input {}; {} of {} answers are wrong", input.where,
                              wrong[0], wrong.size(), inputs.count);
  return failure;
}

// The result of a check before any of its cases is judged.
CheckResult unjudged_result(const Check& check, std::size_t cases, double points) {
  return {.name = check.name,
          .task = check.task,
          .stage = check.stage,
          .hidden = check.hidden,
          .all_or_nothing = check.all_or_nothing,
          .generated = check.generated,
          .max_score = points * double(cases)};
}

}  // namespace

const char* verdict_name(Verdict verdict) {
  constexpr const char* kNames[] = {
      "right",   "wrong answer",   "no answer",        "exception", "crash",
      "timeout", "limit exceeded", "malformed output", "not built", "not written yet"};
  static_assert(std::size(kNames) == std::size_t(Verdict::kUntouched) + 1);
  return kNames[int(verdict)];
}

FirstFailure judge_answer(const Case& input, const CaseAnswer& answer, std::size_t index) {
  const bool answered = answer.state == CaseAnswer::State::kAnswered;
  if (input.generated && answered) return judge_class(input, answer.answer, index);
  FirstFailure failure;
  failure.index = index;
  failure.where = input.where;
  failure.restated = input.restated;
  failure.text = answer.text;
  failure.verdict = verdict_of(answer.state);
  if (answered) failure.divergence = judge_case(input, answer.answer);
  if (failure.divergence) failure.verdict = Verdict::kWrong;
  add_field(input, answer.answer, failure);
  return failure;
}

CheckResult judge_check(const Check& check, const std::vector<Case>& cases,
                        const CheckAnswers& answers, double points) {
  CheckResult result = unjudged_result(check, cases.size(), points);
  result.printed = answers.printed;
  result.seconds = answers.seconds;
  const CaseAnswer none;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const CaseAnswer& answer = i < answers.cases.size() ? answers.cases[i] : none;
    FirstFailure failure = judge_answer(cases[i], answer, i);
    result.cases.push_back(failure.verdict);
    if (failure.verdict == Verdict::kRight) {
      ++result.right;
      continue;
    }
    if (result.first) continue;
    result.verdict = failure.verdict;
    if (failure.verdict == Verdict::kMissing) failure.text = answers.malformed;
    result.first = std::move(failure);
  }
  // If the program wrote a line that is not a valid answer, the cases without an answer are
  // missing; the verdict on the check is then "malformed output".
  if (result.verdict == Verdict::kMissing && !answers.malformed.empty()) {
    result.verdict = result.first->verdict = Verdict::kMalformed;
  }
  // If all cases are right, the score is the full marks exactly, without rounding errors.
  result.score = result.right == cases.size() ? result.max_score
                 : check.all_or_nothing       ? 0
                                              : points * double(result.right);
  if (result.first) result.slips = find_slips(cases, answers.cases);
  return result;
}

bool same_answers(const CheckAnswers& a, const CheckAnswers& b) {
  const auto same_number = [](double x, double y) {
    return x == y || (std::isnan(x) && std::isnan(y));
  };
  const auto same_field = [&](const Answer::Field& x, const Answer::Field& y) {
    return x.name == y.name && std::equal(x.values.begin(), x.values.end(), y.values.begin(),
                                          y.values.end(), same_number);
  };
  return std::equal(a.cases.begin(), a.cases.end(), b.cases.begin(), b.cases.end(),
                    [&](const CaseAnswer& x, const CaseAnswer& y) {
                      const auto &f = x.answer.fields(), &g = y.answer.fields();
                      return x.state == y.state && x.text == y.text &&
                             std::equal(f.begin(), f.end(), g.begin(), g.end(), same_field);
                    });
}

CheckResult not_built_check(const Check& check, std::size_t cases, double points) {
  CheckResult result = unjudged_result(check, cases, points);
  result.verdict = Verdict::kNotBuilt;
  result.cases.assign(cases, Verdict::kNotBuilt);
  return result;
}

namespace {

// Removes each slip whose cause another check names: an edge function with the opposite sign, say,
// also gives triangles the wrong edges, and whoever reads of both would look in two places.
void remove_consequences(std::vector<CheckResult>& checks) {
  std::set<std::string> named;
  for (const CheckResult& check : checks) named.insert(check.slips.begin(), check.slips.end());
  const auto follows = [&](const std::string& id) {
    return std::ranges::any_of(known_slips(), [&](const Slip& slip) {
      return slip.id == id && !slip.cause.empty() && named.count(slip.cause) > 0;
    });
  };
  for (CheckResult& check : checks) std::erase_if(check.slips, follows);
}

}  // namespace

LabResult sum_up(const Lab& lab, std::vector<CheckResult> checks) {
  remove_consequences(checks);
  LabResult result{.number = lab.number, .folder = lab.folder, .title = lab.title};
  for (const Task& task : lab.tasks) {
    TaskResult sum{task.id, task.title, 0, 0};
    for (const CheckResult& check : checks) {
      if (check.task != task.id) continue;
      sum.score += check.score;
      sum.max_score += check.max_score;
    }
    result.score += sum.score;
    result.max_score += sum.max_score;
    result.hidden_points += task.points - sum.max_score;
    result.tasks.push_back(sum);
  }
  // A remainder that is only a rounding error does not mean that there is a hidden check.
  if (result.hidden_points < 1e-9) result.hidden_points = 0;
  result.checks = std::move(checks);
  return result;
}

}  // namespace glassbox::labs
