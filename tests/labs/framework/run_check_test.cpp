// Processes that crash, hang, shout or lie: each case has a verdict, and nobody waits for long.
#include <chrono>
#include <filesystem>
#include <fstream>

#include "labs/framework/judge.h"
#include "labs/framework/process.h"
#include "labs/framework/run_check.h"
#include "tests/support/catch.h"

using namespace glassbox::labs;
using State = CaseAnswer::State;

namespace {

namespace fs = std::filesystem;

// A runner made of shell: $from is the first case, `answer N` answers one.
class Script {
public:
  explicit Script(const std::string& body) {
    path_ = fs::temp_directory_path() / ("glassbox-script-" + std::to_string(getpid()) + ".sh");
    std::ofstream file(path_);
    file << "#!/bin/sh\nfrom=$4\nanswer() { echo \"{\\\"case\\\": $1, \\\"fields\\\": "
            "{\\\"f\\\": [$1]}}\" >&3; }\n"
         << body << "\n";
    file.close();
    fs::permissions(path_, fs::perms::owner_all);
  }
  ~Script() { fs::remove(path_); }
  CheckAnswers run(std::size_t cases, double seconds = 10) const {
    LocalRunner runner;
    RunLimits limits;
    limits.seconds = seconds;
    limits.output_bytes = 1 << 20;
    return run_check(runner, path_, "a check", cases, limits);
  }

private:
  fs::path path_;
};

}  // namespace

TEST_CASE("a crash costs its own case, and the others are still put") {
  const auto answers = Script(
                           "i=$from; while [ $i -lt 4 ]; do [ $i = 1 ] && kill -SEGV $$; answer "
                           "$i; i=$((i+1)); done")
                           .run(4);
  CHECK(answers.cases[0].state == State::kAnswered);
  CHECK(answers.cases[1].state == State::kCrashed);
  CHECK(answers.cases[1].text.find("SIGSEGV") != std::string::npos);
  CHECK(answers.cases[2].state == State::kAnswered);
  CHECK(answers.cases[3].state == State::kAnswered);
}

TEST_CASE("an exit before the answer is called so") {
  const auto answers = Script("exit 0").run(2);
  CHECK(answers.cases[0].state == State::kCrashed);
  CHECK(answers.cases[0].text.find("exit status 0") != std::string::npos);
}

TEST_CASE("a process that hangs is stopped, and so is what it has started") {
  const auto start = std::chrono::steady_clock::now();
  const auto answers = Script("answer 0; sleep 60 & sleep 60").run(3, 0.5);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  CHECK(took.count() < 10);
  CHECK(answers.cases[0].state == State::kAnswered);
  CHECK(answers.cases[1].state == State::kTimeout);
  CHECK(answers.cases[2].state == State::kMissing);
}

TEST_CASE("a process whose child keeps the pipes open does not keep the reader") {
  const auto start = std::chrono::steady_clock::now();
  const auto answers = Script("answer 0; sleep 60 & exit 0").run(1);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  CHECK(took.count() < 10);
  CHECK(answers.cases[0].state == State::kAnswered);
}

TEST_CASE("answers without end are cut off") {
  const auto answers = Script("yes >&3").run(1);
  CHECK(answers.cases[0].state == State::kLimit);
}

TEST_CASE("what the code prints is kept apart from its answers") {
  const auto answers = Script("echo hello; echo there >&2; answer 0").run(1);
  CHECK(answers.said == "hello\nthere\n");
  CHECK(answers.cases[0].state == State::kAnswered);
}

TEST_CASE("nonsense in place of answers is malformed") {
  const auto answers = Script("echo nonsense >&3").run(1);
  Check check;
  check.name = "a check";
  const auto result = judge_check(check, std::vector<Case>(1), answers, 1);
  CHECK(result.verdict == Verdict::kMalformed);
  CHECK(result.score == 0);
}

TEST_CASE("a program that is not there is no answer") {
  LocalRunner runner;
  const auto answers = run_check(runner, "/nowhere/runner", "a check", 2, {});
  CHECK(answers.cases[0].state == State::kCrashed);
  CHECK(answers.cases[0].text.find("could not be started") != std::string::npos);
}

TEST_CASE("points are shared by the cases of a task's checks, hidden ones too") {
  Lab lab;
  lab.tasks = {{"1.1", "first", 6}, {"1.2", "second", 4}};
  lab.checks.resize(3);
  lab.checks[0].task = lab.checks[1].task = "1.1";
  lab.checks[2].task = "1.2";
  CHECK(points_of_case(lab, {2, 4, 8}, "1.1") == 1);
  CHECK(points_of_case(lab, {2, 4, 8}, "1.2") == 0.5);

  lab.checks[0].name = "visible";
  CheckAnswers answers;
  answers.cases.resize(2);
  answers.cases[0].state = State::kAnswered;
  const CheckResult half = judge_check(lab.checks[0], std::vector<Case>(2), answers, 1);
  CHECK(half.score == 1);
  CHECK(half.max_score == 2);
  const LabResult result = sum_up(lab, {half});
  CHECK(result.score == 1);
  CHECK(result.max_score == 2);
  CHECK(result.hidden_points == 8);
}
