// Processes that crash, hang, print without end or lie: each case gets a verdict, and the test
// never waits for long.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "cli/process/process.h"
#include "labs/framework/judge_check.h"
#include "labs/framework/lab_points.h"
#include "labs/framework/run_check.h"
#include "tests/support/catch.h"

using namespace glassbox::labs;
using State = CaseAnswer::State;

namespace {

namespace fs = std::filesystem;

// A runner that is a shell script: $from is the number of the first case, and `answer N` answers
// case N.
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

// A file in which a process that a script started writes about itself.
class Started {
public:
  Started() : file_(fs::temp_directory_path() / ("glassbox-started-" + std::to_string(getpid()))) {
    fs::remove(file_);
  }
  ~Started() { fs::remove(file_); }
  std::string file() const { return file_.string(); }
  std::string text() const {
    std::ifstream in(file_);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  // Whether the process named in the file has not ended. A zombie has ended, although its parent
  // may not have noticed yet.
  bool runs() const {
    const std::string number = text().substr(0, text().find('\n'));
    REQUIRE_FALSE(number.empty());
    std::ifstream stat("/proc/" + number + "/stat");
    std::string id, name, state;  // "123 (sleep) S ..."
    if (!(stat >> id >> name >> state)) return false;
    return state != "Z" && state != "X";
  }

private:
  fs::path file_;
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
  const Started other;
  const auto answers =
      Script("answer 0; sleep 600 & echo $! >" + other.file() + "; sleep 600").run(3, 2);
  CHECK(answers.cases[0].state == State::kAnswered);
  CHECK(answers.cases[1].state == State::kTimeout);
  CHECK(answers.cases[2].state == State::kMissing);
  // the process may end a little after the signal
  for (int i = 0; i < 1000 && other.runs(); ++i) usleep(10000);
  CHECK_FALSE(other.runs());
}

TEST_CASE("a process whose child keeps the pipes open does not keep the reader") {
  // If the child were waited for, it would have written its second line.
  const Started other;
  const auto answers = Script("answer 0; { echo $$; sleep 60; echo ended; } >" + other.file() +
                              " & until [ -s " + other.file() + " ]; do sleep 0.01; done; exit 0")
                           .run(1);
  CHECK(other.text().find("ended") == std::string::npos);
  CHECK(answers.cases[0].state == State::kAnswered);
}

TEST_CASE("answers without end are cut off") {
  const auto answers = Script("yes >&3").run(1);
  CHECK(answers.cases[0].state == State::kLimit);
}

TEST_CASE("what the code prints is kept apart from its answers") {
  const auto answers = Script("echo hello; echo there >&2; answer 0").run(1);
  CHECK(answers.printed == "hello\nthere\n");
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

TEST_CASE("a task's points are shared by its checks, and a check's by its cases") {
  Lab lab;
  lab.tasks = {{"1.1", "first", 6}, {"1.2", "second", 4}};
  lab.checks.resize(3);
  lab.checks[0].task = lab.checks[1].task = "1.1";
  lab.checks[2].task = "1.2";
  CHECK(points_of_case(lab, lab.checks[0], 2) == 1.5);
  CHECK(points_of_case(lab, lab.checks[1], 4) == 0.75);
  CHECK(points_of_case(lab, lab.checks[2], 8) == 0.5);
  lab.checks[1].weight = 2;
  CHECK(points_of_case(lab, lab.checks[0], 2) == 1);
  CHECK(points_of_case(lab, lab.checks[1], 4) == 1);

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
