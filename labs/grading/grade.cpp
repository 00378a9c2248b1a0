#include "labs/grading/grade.h"

#include <string.h>

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "labs/framework/batch.h"
#include "labs/framework/lab_points.h"
#include "labs/framework/run_check.h"
#include "labs/framework/run_in_parallel.h"
#include "labs/framework/shrink.h"
#include "labs/grading/compile.h"
#include "labs/grading/sanitizer_report.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;
using Ending = RunOutcome::Ending;

using AllCases = std::vector<std::vector<Case>>;  // the cases of each check

AllCases cases_of(const Lab& lab) {
  AllCases cases;
  for (const Check& check : lab.checks) cases.push_back(check.cases());
  return cases;
}

GradedSubmission ungraded_submission(const Lab& lab, const AllCases& cases,
                                     const std::string& outcome, bool hidden) {
  GradedSubmission graded;
  std::vector<CheckResult> checks;
  for (std::size_t i = 0; i < lab.checks.size(); ++i) {
    if (lab.checks[i].hidden && !hidden) continue;
    const std::size_t count = cases[i].size();
    checks.push_back(
        not_built_check(lab.checks[i], count, points_of_case(lab, lab.checks[i], count)));
  }
  graded.outcome = outcome;
  graded.check_outcomes.assign(checks.size(), outcome);
  graded.result = sum_up(lab, std::move(checks));
  return graded;
}

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", signal);
}

// The time that all failures of a submission have together to be shrunk, in seconds. It is none of
// the time of the checks, so that a wrong answer in one check cannot cost points in another one.
constexpr double kShrinkSeconds = 20;

// How many inputs of a class are compared with the starter's answers. A function that is written
// answers otherwise to one of so many inputs of each class, unless it has the starter's answer for
// all that the class is about.
constexpr std::size_t kCompared = 100;

// The answers to the first inputs of each class, each as a case of its own. The batches are of
// these inputs alone (`of_first`) or of all. Nothing if a batch is missing or malformed.
std::optional<CheckAnswers> first_answers(const CheckAnswers& batches,
                                          const std::vector<Case>& cases, bool of_first) {
  CheckAnswers first;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto all = std::size_t(cases[i].generated->count), some = std::min(all, kCompared);
    if (batches.cases[i].state != CaseAnswer::State::kAnswered) return std::nullopt;
    const auto answers = split_batch(batches.cases[i].answer, of_first ? some : all);
    if (!answers) return std::nullopt;
    for (std::size_t k = 0; k < some; ++k)
      first.cases.push_back({CaseAnswer::State::kAnswered, (*answers)[k], ""});
  }
  return first;
}

// Runs and judges the checks of one submission.
class GradingRun {
public:
  GradingRun(const GradeRequest& request, const AllCases& cases)
      : request_(request),
        cases_(cases),
        programs_(cases.size()),
        time_(request.total_seconds),
        shrink_time_(kShrinkSeconds) {
    results.resize(cases.size());
    check_outcomes.resize(cases.size());
  }

  void run_checks(const fs::path& program, const fs::path& starter, bool hidden) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      if (request_.lab.checks[i].hidden == hidden && !cases_[i].empty()) chosen.push_back(i);
    }
    for (const std::size_t i : chosen) programs_[i] = program;
    run_in_parallel(
        chosen.size(), [&](std::size_t k) { run_one_check(program, starter, chosen[k]); },
        request_.max_parallel_checks);
  }

  // After all checks. One after the other, because each starts many processes, and their number is
  // limited.
  void shrink_first_failures() {
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      if (!programs_[i].empty()) shrink_first_failure(i);
    }
  }

  std::vector<CheckResult> results;
  std::vector<std::string> check_outcomes;

private:
  void run_one_check(const fs::path& program, const fs::path& starter, std::size_t i) {
    const Check& check = request_.lab.checks[i];
    SandboxRunner runner(request_.sandbox, request_.limits, request_.compile_options.sanitize,
                         &time_);
    const CheckAnswers answers = answers_of(runner, program, i);
    CheckResult& result = results[i];
    result = judge_check(check, cases_[i], answers,
                         points_of_case(request_.lab, check, cases_[i].size()));
    check_outcomes[i] = check_outcome(result, runner.processes());
    if (request_.compile_options.sanitize) report_sanitizer_finding(result, check_outcomes[i]);
    if (is_untouched(result, answers, starter, i)) {
      result.verdict = result.first->verdict = Verdict::kUntouched;
      check_outcomes[i] = verdict_name(Verdict::kUntouched);
    }
  }

  void shrink_first_failure(std::size_t i) {
    const bool sanitize = request_.compile_options.sanitize;
    // A sanitizer's finding is that of one input, and another input may have another one.
    if (sanitize && results[i].verdict == Verdict::kCrash) return;
    SandboxRunner runner(request_.sandbox, request_.limits, sanitize, &shrink_time_);
    shrink_failure(results[i], cases_[i], runner, programs_[i], run_limits());
  }

  // Whether every answer is the starter's; of generated inputs, every answer to the first ones of
  // each class.
  bool is_untouched(const CheckResult& result, const CheckAnswers& answers, const fs::path& starter,
                    std::size_t i) const {
    if (result.right > 0 || starter.empty()) return false;
    SandboxRunner runner(request_.sandbox, request_.limits);
    const std::vector<Case>& cases = cases_[i];
    const auto own =
        request_.lab.checks[i].generated ? first_answers(answers, cases, false) : std::nullopt;
    if (!own) return same_answers(answers, answers_of(runner, starter, i));
    const CheckAnswers of_starter = run_check(runner, starter, request_.lab.checks[i].name,
                                              cases.size(), run_limits(), kCompared);
    const auto others = first_answers(of_starter, cases, true);
    return others && same_answers(*own, *others);
  }

  // Names the sanitizer's finding as the outcome in place of a crash. A sanitizer ends the process
  // with an exit status of its own, after it has printed the reason.
  static void report_sanitizer_finding(CheckResult& result, std::string& outcome) {
    const auto finding = sanitizer_finding(result.printed);
    if (!finding || !result.first || result.verdict != Verdict::kCrash) return;
    outcome = result.first->text = *finding;
    result.printed.clear();  // the sanitizer's report, which begins with the error that is named
  }

  CheckAnswers answers_of(Runner& runner, const fs::path& program, std::size_t i) const {
    return run_check(runner, program, request_.lab.checks[i].name, cases_[i].size(), run_limits());
  }

  RunLimits run_limits() const {
    const Limits& limits = request_.limits;
    return {limits.seconds, limits.output_bytes, limits.kept_bytes};
  }

  const GradeRequest& request_;
  const AllCases& cases_;
  std::vector<fs::path> programs_;  // with which each check was run; empty: it was not run
  TimeBudget time_, shrink_time_;
};

}  // namespace

GradedSubmission ungraded_submission(const Lab& lab, const std::string& outcome, bool hidden) {
  return ungraded_submission(lab, cases_of(lab), outcome, hidden);
}

std::string check_outcome(const CheckResult& check, const std::vector<RunOutcome>& processes) {
  if (check.verdict == Verdict::kRight) return "passed";
  const bool ended_badly = check.verdict == Verdict::kCrash || check.verdict == Verdict::kTimeout ||
                           check.verdict == Verdict::kLimit;
  // The verdict is that on the first case that is not right. If a process ended badly in that case,
  // it was the first process, because all cases before it were answered.
  if (!ended_badly || processes.empty()) return verdict_name(check.verdict);
  const RunOutcome& first = processes.front();
  switch (first.ending) {
    case Ending::kExit:
      return fmt::format("no answer (ended with exit status {})", first.code);
    case Ending::kSignal:
      return first.detail.empty() ? fmt::format("crash ({})", signal_name(first.code))
                                  : fmt::format("crash ({})", first.detail);
    case Ending::kTimeout:
      return first.detail.empty() ? "timeout" : fmt::format("timeout ({})", first.detail);
    case Ending::kTooMuchOutput:
      return "too much output";
    case Ending::kOutOfMemory:
      return "out of memory";
    case Ending::kForbidden:
      return first.detail.empty() ? "forbidden call"
                                  : fmt::format("forbidden call ({})", first.detail);
    case Ending::kNotStarted:
      return "not started";
  }
  return verdict_name(check.verdict);
}

GradedSubmission grade(const GradeRequest& request, const Result<std::string>& submission) {
  const AllCases cases = cases_of(request.lab);
  if (!submission) {
    const bool missing = submission.error().cause.starts_with("is missing");
    GradedSubmission graded = ungraded_submission(
        request.lab, cases, missing ? "missing file" : "file refused", request.hidden);
    graded.messages = submission.error().message();
    return graded;
  }
  const Sandbox& sandbox = request.sandbox;
  CompileResult compiled =
      compile_submission(*submission, sandbox, request.kit, request.build, request.compile_options);
  const auto not_built = [&](const std::string& outcome) {
    GradedSubmission graded = ungraded_submission(request.lab, cases, outcome, request.hidden);
    graded.messages = graded.result.not_built = compiled.messages;
    return graded;
  };
  if (!compiled.failure.empty()) return not_built(compiled.failure);
  GradingRun grading_run(request, cases);
  // The visible checks run first, in a program that does not contain the hidden checks and
  // therefore cannot reveal anything of them.
  for (const CheckSelection which : {CheckSelection::kVisible, CheckSelection::kAll}) {
    if (which == CheckSelection::kAll && !request.hidden) break;
    const fs::path program = link_submission(which, sandbox, request.kit, request.build,
                                             compiled.messages, request.compile_options);
    if (program.empty()) return not_built("compile error");
    grading_run.run_checks(program, link_starter(which, sandbox, request.kit, request.build),
                           which == CheckSelection::kAll);
  }
  grading_run.shrink_first_failures();
  GradedSubmission graded;
  graded.outcome = "graded";
  graded.messages = compiled.messages;
  // The result of a check that was not run has no name, and is removed.
  std::erase_if(grading_run.results, [](const CheckResult& each) { return each.name.empty(); });
  std::erase_if(grading_run.check_outcomes, [](const std::string& each) { return each.empty(); });
  graded.check_outcomes = std::move(grading_run.check_outcomes);
  graded.result = sum_up(request.lab, std::move(grading_run.results));
  return graded;
}

}  // namespace glassbox::labs::grading
