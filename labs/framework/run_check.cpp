#include "labs/framework/run_check.h"

#include <signal.h>
#include <string.h>
#include <sys/wait.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/process/process.h"
#include "labs/framework/varied_inputs.h"

namespace glassbox::labs {

namespace {

using Ending = RunOutcome::Ending;

// Records how the process ended in `answer`, which belongs to the first case that was not answered.
void record_failure(CaseAnswer& answer, const RunOutcome& outcome, const RunLimits& limits) {
  answer.text = ending_text(outcome, limits);
  switch (outcome.ending) {
    case Ending::kExit:
    case Ending::kSignal:
    case Ending::kNotStarted:
      answer.state = CaseAnswer::State::kCrashed;
      return;
    case Ending::kTimeout:
      answer.state = CaseAnswer::State::kTimeout;
      return;
    case Ending::kTooMuchOutput:
    case Ending::kOutOfMemory:
    case Ending::kForbidden:
      answer.state = CaseAnswer::State::kLimit;
      return;
  }
}

std::size_t first_missing(const CheckAnswers& answers, std::size_t from) {
  while (from < answers.cases.size() && answers.cases[from].state != CaseAnswer::State::kMissing) {
    ++from;
  }
  return from;
}

}  // namespace

std::string choices_text(const std::vector<std::vector<std::uint64_t>>& choices) {
  std::vector<std::string> inputs;
  for (const auto& each : choices) inputs.push_back(fmt::format("{}", fmt::join(each, " ")));
  return fmt::format("{}", fmt::join(inputs, ";"));
}

RunOutcome LocalRunner::run(const RunRequest& request) {
  std::vector<std::string> argv{request.program.string()};
  argv.insert(argv.end(), request.arguments.begin(), request.arguments.end());
  argv.insert(argv.end(), {"--out-fd", std::to_string(kAnswersFd)});
  const RunLimits& limits = request.limits;
  ProcessOutcome process =
      run_process(argv, {limits.seconds, limits.output_bytes, limits.printed_bytes});
  RunOutcome outcome;
  outcome.answers = std::move(process.answers);
  outcome.printed = std::move(process.printed);
  outcome.seconds = process.seconds;
  outcome.detail = process.why_not_started;
  if (!process.started) {
    outcome.ending = Ending::kNotStarted;
  } else if (process.timed_out) {
    outcome.ending = Ending::kTimeout;
  } else if (process.too_much) {
    outcome.ending = Ending::kTooMuchOutput;
  } else if (WIFSIGNALED(process.status)) {
    outcome.ending = Ending::kSignal;
    outcome.code = WTERMSIG(process.status);
  } else {
    outcome.ending = Ending::kExit;
    outcome.code = WEXITSTATUS(process.status);
  }
  return outcome;
}

std::string ending_text(const RunOutcome& outcome, const RunLimits& limits) {
  const std::string detail = outcome.detail.empty() ? "" : ": " + outcome.detail;
  switch (outcome.ending) {
    case Ending::kExit:
      return fmt::format("the program ended with exit status {} before it answered{}", outcome.code,
                         detail);
    case Ending::kSignal: {
      const char* name = sigabbrev_np(outcome.code);
      const char* what = sigdescr_np(outcome.code);
      return fmt::format("killed by signal {} (SIG{}, {}){}", outcome.code,
                         name != nullptr ? name : "?", what != nullptr ? what : "unknown", detail);
    }
    case Ending::kTimeout:
      return fmt::format("the program was still running after {} seconds{}", limits.seconds,
                         detail);
    case Ending::kTooMuchOutput:
      return !outcome.detail.empty() ? outcome.detail
                                     : fmt::format("the program wrote more than {} MiB of answers",
                                                   limits.output_bytes >> 20);
    case Ending::kOutOfMemory:
      return "the program used more memory than is allowed" + detail;
    case Ending::kForbidden:
      return "the program made a forbidden system call" + detail;
    case Ending::kNotStarted:
      return "the program could not be started" + detail;
  }
  return "";
}

CaseAnswer run_inputs(Runner& runner, const std::filesystem::path& program,
                      const std::string& check, std::size_t index, const SomeInputs& inputs,
                      const RunLimits& limits) {
  std::vector<std::string> words{"--check", check, "--case", std::to_string(index)};
  if (inputs_seed() != 0) words.insert(words.end(), {"--seed", std::to_string(inputs_seed())});
  if (inputs.choices.empty()) {
    words.insert(words.end(),
                 {"--inputs", std::to_string(inputs.first), std::to_string(inputs.end)});
  } else {
    words.insert(words.end(), {"--choices", choices_text(inputs.choices)});
  }
  const RunOutcome outcome = runner.run({program, words, limits});
  CheckAnswers answers;
  answers.cases.resize(index + 1);
  read_answers(outcome.answers, answers);
  CaseAnswer& answer = answers.cases[index];
  if (answer.state == CaseAnswer::State::kMissing) record_failure(answer, outcome, limits);
  if (outcome.ending == Ending::kNotStarted) answer.state = CaseAnswer::State::kLimit;
  return answer;
}

CheckAnswers run_check(Runner& runner, const std::filesystem::path& program,
                       const std::string& check, std::size_t cases, const RunLimits& limits,
                       std::size_t inputs) {
  CheckAnswers answers;
  answers.check = check;
  answers.cases.resize(cases);
  std::size_t from = 0;
  for (int restarts = 0; from < cases; ++restarts) {
    std::vector<std::string> words{"--check", check, "--from", std::to_string(from)};
    if (inputs_seed() != 0) words.insert(words.end(), {"--seed", std::to_string(inputs_seed())});
    if (inputs > 0) words.insert(words.end(), {"--inputs", "0", std::to_string(inputs)});
    const RunOutcome outcome = runner.run({program, words, limits});
    read_answers(outcome.answers, answers);
    if (answers.printed.size() < limits.printed_bytes)
      answers.printed += outcome.printed.substr(0, limits.printed_bytes - answers.printed.size());
    answers.seconds += outcome.seconds;
    const std::size_t stuck = first_missing(answers, from);
    if (stuck == cases) break;
    // If the process ended normally, it went through all cases. A case without an answer then means
    // that the program wrote something else in place of the answer.
    const bool well = outcome.ending == Ending::kExit && outcome.code == 0;
    if (!(well && !answers.malformed.empty()))
      record_failure(answers.cases[stuck], outcome, limits);
    const bool again = outcome.ending == Ending::kSignal || outcome.ending == Ending::kExit;
    if (!again || restarts == kMaxRestarts) {
      for (std::size_t i = stuck + 1; i < cases; ++i) {
        if (answers.cases[i].state == CaseAnswer::State::kMissing)
          answers.cases[i].text = "the program ended before this case";
      }
      break;
    }
    from = stuck + 1;
  }
  return answers;
}

}  // namespace glassbox::labs
