#include "labs/grading/grade.h"

#include <string.h>

#include <fmt/format.h>

#include "labs/framework/run_check.h"
#include "labs/grading/submission.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;
using Ending = RunOutcome::Ending;

struct Cases {
  std::vector<std::vector<Case>> of_check;
  std::vector<double> points;  // of one case
};

Cases cases_of(const Lab& lab) {
  Cases cases;
  std::vector<std::size_t> counts;
  for (const Check& check : lab.checks) {
    cases.of_check.push_back(check.cases());
    counts.push_back(cases.of_check.back().size());
  }
  for (const Check& check : lab.checks)
    cases.points.push_back(points_of_case(lab, counts, check.task));
  return cases;
}

Graded nothing(const Lab& lab, const Cases& cases, const std::string& outcome) {
  Graded graded;
  std::vector<CheckResult> checks;
  for (std::size_t i = 0; i < lab.checks.size(); ++i)
    checks.push_back(not_built_check(lab.checks[i], cases.of_check[i].size(), cases.points[i]));
  graded.result = sum_up(lab, std::move(checks));
  graded.outcome = outcome;
  graded.names.assign(lab.checks.size(), outcome);
  return graded;
}

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
    text.erase(at, part.size());
  return text;
}

// Empty if the compiler was content.
std::string compile_trouble(const RunOutcome& outcome, const Limits& limits, std::string& said) {
  switch (outcome.ending) {
    case Ending::kExit:
      return outcome.code == 0 ? "" : "compile error";
    case Ending::kTimeout:
      said = fmt::format("The compiler was still busy after {} seconds.\n{}", limits.seconds, said);
      return "compile timeout";
    case Ending::kTooMuchOutput:
      said = "The compiler wrote more than it may.\n" + said;
      return "compile error";
    case Ending::kNotStarted:
      said = outcome.detail;
      return "grading did not finish";
    default:
      said = fmt::format("The compiler did not survive (signal {}).\n{}", outcome.code, said);
      return "compile error";
  }
}

// A file that a submission included and that is neither the compiler's nor the lab's; empty if there is none. Where the sandbox
// hides files there cannot be.
std::string foreign_file(const fs::path& build, const Kit& kit) {
  const auto rule = read_text_file(build / kFilesRead);
  if (!rule) return "a file that is not named";
  for (const fs::path& header : headers_of(*rule)) {
    if (!Sandbox::is_compilers(build / header, {kit.readable, build})) return header.string();
  }
  return {};
}

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", signal);
}

}  // namespace

Graded nothing_yet(const Lab& lab, const std::string& outcome) {
  return nothing(lab, cases_of(lab), outcome);
}

std::string name_of(const CheckResult& check, const std::vector<RunOutcome>& processes) {
  if (check.verdict == Verdict::kRight) return "passed";
  const bool ended_badly = check.verdict == Verdict::kCrash || check.verdict == Verdict::kTimeout ||
                           check.verdict == Verdict::kLimit;
  // The first case that is not right is one that the first process reached, unless that process ended there.
  if (!ended_badly || processes.empty()) return verdict_name(check.verdict);
  const RunOutcome& first = processes.front();
  switch (first.ending) {
    case Ending::kExit:
      return fmt::format("no answer (ended with exit status {})", first.code);
    case Ending::kSignal:
      return first.detail.empty() ? fmt::format("crash ({})", signal_name(first.code))
                                  : fmt::format("crash ({})", first.detail);
    case Ending::kTimeout:
      return "timeout";
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

Graded grade(const Lab& lab, const fs::path& submission, const Sandbox& sandbox, const Kit& kit,
             const fs::path& build, const Limits& limits) {
  const Cases cases = cases_of(lab);
  const auto text = read_submission(submission);
  if (!text) {
    const bool missing = text.error().cause == "is missing";
    Graded graded = nothing(lab, cases, missing ? "missing file" : "file refused");
    graded.said = text.error().message();
    return graded;
  }
  const auto written = write_if_changed(build / "student.cpp", *text);
  if (!written || !sandbox.hand_over(build) || !sandbox.hand_over(build / "student.cpp")) {
    Graded graded = nothing(lab, cases, "grading did not finish");
    graded.said = written ? "the build directory cannot be handed over" : written.error().message();
    return graded;
  }
  const RunOutcome compiled = sandbox.compile(compile_command(kit, "student.cpp", "runner"), build,
                                              {kit.readable}, compile_limits());
  std::string said =
      without(without(compiled.said, build.string() + "/"), kit.include.string() + "/");
  if (const std::string trouble = compile_trouble(compiled, compile_limits(), said);
      !trouble.empty()) {
    Graded graded = nothing(lab, cases, trouble);
    graded.said = said;
    graded.result.not_built = said;
    return graded;
  }
  if (const std::string foreign = foreign_file(build, kit); !foreign.empty()) {
    Graded graded = nothing(lab, cases, "compile error");
    graded.said = "student.cpp includes " + foreign + ", which is not part of the lab.\n";
    graded.result.not_built = graded.said;
    return graded;
  }
  Graded graded;
  graded.outcome = "graded";
  graded.said = said;
  std::vector<CheckResult> checks;
  for (std::size_t i = 0; i < lab.checks.size(); ++i) {
    SandboxRunner runner(sandbox, limits);
    const CheckAnswers answers =
        run_check(runner, build / "runner", lab.checks[i].name, cases.of_check[i].size(),
                  {limits.seconds, limits.output_bytes, limits.kept_bytes});
    checks.push_back(judge_check(lab.checks[i], cases.of_check[i], answers, cases.points[i]));
    graded.names.push_back(name_of(checks.back(), runner.processes()));
  }
  graded.result = sum_up(lab, std::move(checks));
  return graded;
}

}  // namespace glassbox::labs::grading
