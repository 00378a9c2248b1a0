#include "labs/grading/grade.h"

#include <string.h>

#include <algorithm>

#include <fmt/format.h>

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

// Runs and judges the checks of one program.
class GradingRun {
public:
  GradingRun(const GradeRequest& request, const AllCases& cases)
      : request_(request), cases_(cases), time_(request.total_seconds) {
    results.resize(cases.size());
    check_outcomes.resize(cases.size());
  }

  void run_checks(const fs::path& program, const fs::path& starter, bool hidden) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      if (request_.lab.checks[i].hidden == hidden && !cases_[i].empty()) chosen.push_back(i);
    }
    run_in_parallel(
        chosen.size(), [&](std::size_t k) { run_one_check(program, starter, chosen[k]); },
        request_.max_parallel_checks);
    // One after the other, because each starts many processes, and their number is limited.
    for (const std::size_t i : chosen) shrink_first_failure(program, i);
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

  void shrink_first_failure(const fs::path& program, std::size_t i) {
    SandboxRunner runner(request_.sandbox, request_.limits, request_.compile_options.sanitize,
                         &time_);
    shrink_failure(results[i], cases_[i], runner, program, run_limits());
  }

  // Whether every answer is the starter's.
  bool is_untouched(const CheckResult& result, const CheckAnswers& answers, const fs::path& starter,
                    std::size_t i) const {
    if (result.right > 0 || starter.empty()) return false;
    SandboxRunner runner(request_.sandbox, request_.limits);
    return same_answers(answers, answers_of(runner, starter, i));
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
  TimeBudget time_;
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
