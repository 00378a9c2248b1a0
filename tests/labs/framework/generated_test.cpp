// Generated inputs: the choices that make them, the answers of many in one line, and how an input
// with a wrong answer becomes simpler.
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "labs/framework/batch.h"
#include "labs/framework/choices.h"
#include "labs/framework/judge_check.h"
#include "labs/framework/run_check.h"
#include "labs/framework/shrink.h"
#include "tests/support/catch.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

// The inputs are two numbers, and the right answer is their sum.
struct Pair {
  std::int64_t a = 0, b = 0;
};

Pair any_pair(Choices& c) {
  return {c.integer(-100'000, 100'000), c.integer(-100'000, 100'000)};
}
std::vector<InputClass<Pair>> pairs() {
  return {{"pairs", 3000, any_pair}, {"zeros", 3, [](Choices&) { return Pair(); }}};
}
Case expect_sum(const Pair& pair) {
  return {
      fmt::format("{} and {}", pair.a, pair.b), "", {numbers("sum", {double(pair.a + pair.b)})}};
}

std::string bits_of(double value) {
  return fmt::format("{:016x}", std::bit_cast<std::uint64_t>(value));
}

// A runner in this process. The student's function is `answer`: it returns the sum, throws, or sets
// `crash`.
class FakeRunner : public Runner {
public:
  using Function = double (*)(const Pair& pair, bool& crash);
  explicit FakeRunner(Function answer) : answer_(answer) {}

  RunOutcome run(const RunRequest& request) override {
    ++runs;
    const std::vector<std::string>& words = request.arguments;
    const auto after = [&](const char* option) -> const std::string* {
      const auto at = std::find(words.begin(), words.end(), option);
      return at == words.end() ? nullptr : &*(at + 1);
    };
    RunOutcome outcome;
    outcome.ending = RunOutcome::Ending::kExit;
    std::string digits;
    try {
      for (const Pair& pair : inputs_of(after("--choices"), after("--inputs"))) {
        bool crash = false;
        digits += bits_of(answer_(pair, crash));
        if (crash) {
          outcome.ending = after("--choices") != nullptr ? bad_end : RunOutcome::Ending::kSignal;
          outcome.code = 11;
          return outcome;
        }
      }
      outcome.answers =
          "{\"case\": 0, \"fields\": {\"sum\": \"" + digits + "\"}, \"sizes\": {\"sum\": [1]}}\n";
    } catch (const std::exception& error) {
      outcome.answers = fmt::format("{{\"case\": 0, \"threw\": \"{}\"}}\n", error.what());
    }
    return outcome;
  }

  int runs = 0;
  // how a process with given inputs ends where `crash` is set
  RunOutcome::Ending bad_end = RunOutcome::Ending::kSignal;

private:
  static std::vector<Pair> inputs_of(const std::string* choices, const std::string* first) {
    std::vector<Pair> all;
    if (choices != nullptr) {
      std::istringstream lists(*choices + ";");
      for (std::string list; std::getline(lists, list, ';');) {
        std::istringstream numbers(list);
        std::vector<std::uint64_t> given;
        for (std::uint64_t number = 0; numbers >> number;) given.push_back(number);
        Choices made(given);
        all.push_back(any_pair(made));
      }
      return all;
    }
    const int begin = first != nullptr ? std::stoi(*first) : 0;
    const int end = first != nullptr ? std::stoi(*(first + 1)) : 3000;
    for (int i = begin; i < end; ++i) {
      Choices random(input_seed(0, "pairs", i));
      all.push_back(any_pair(random));
    }
    return all;
  }

  Function answer_;
};

// Judges the first class with the answers of the function, and shrinks the first failure.
CheckResult judged(FakeRunner& runner) {
  const Check check = generated_check("sums", "1.1", "world", pairs, expect_sum);
  std::vector<Case> cases = check.cases();
  cases.resize(1);
  const CheckAnswers answers = run_check(runner, "", "sums", 1, {});
  CheckResult result = judge_check(check, cases, answers, 1);
  shrink_failure(result, cases, runner, "", {});
  return result;
}

}  // namespace

TEST_CASE("a choice of a whole number offers each once, the one nearest to 0 first") {
  for (const auto& [low, high] :
       {std::pair{-3, 3}, {-2, 7}, {-7, 2}, {0, 9}, {-9, 0}, {4, 8}, {-8, -4}}) {
    std::set<std::int64_t> offered;
    for (std::uint64_t choice = 0; choice <= std::uint64_t(high - low); ++choice) {
      Choices choices(std::vector<std::uint64_t>{choice});
      const std::int64_t number = choices.integer(low, high);
      CHECK(number >= low);
      CHECK(number <= high);
      offered.insert(number);
    }
    CHECK(offered.size() == std::size_t(high - low + 1));
    Choices simplest(std::vector<std::uint64_t>{});
    CHECK(simplest.integer(low, high) == std::clamp(0, low, high));
  }
}

TEST_CASE("the same choices make the same input, and choices outside of what is offered another") {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Choices random(seed);
    const double number = random.real(-1074, 1023);
    const std::int64_t whole = random.sized(61);
    Choices again(random.made());
    CHECK(again.real(-1074, 1023) == number);
    CHECK(again.sized(61) == whole);
    CHECK(std::isfinite(number));
    CHECK(number != 0);
    Random numbers(seed);
    Choices wild(std::vector<std::uint64_t>{numbers.bits(), numbers.bits(), numbers.bits()});
    CHECK(std::isfinite(wild.real(-1074, 1023)));
  }
}

TEST_CASE(
    "answers to many inputs are split by their sizes, and refused where the sizes are wrong") {
  Answer batch;
  batch.emit("f", {1, 2, 3});
  batch.emit("f/sizes", {2, 0, 1});
  batch.emit("g", {7, 8, 9});
  batch.emit("g/sizes", {1});
  batch.emit("h", {5});
  batch.emit("h/sizes", {-1, 1, -1});  // the second answer alone has this field
  const auto answers = split_batch(batch, 3);
  REQUIRE(answers);
  CHECK((*answers)[0].fields().size() == 2);
  CHECK((*answers)[1].fields().size() == 3);
  CHECK((*answers)[0].fields()[0].values == std::vector<double>{1, 2});
  CHECK((*answers)[1].fields()[0].values.empty());
  CHECK((*answers)[2].fields()[0].values == std::vector<double>{3});
  CHECK((*answers)[2].fields()[1].values == std::vector<double>{9});
  for (const std::vector<double>& sizes : {std::vector<double>{2, 0},
                                           {2, 0, 2},
                                           {2, 1, 1},
                                           {-2, 2, 1},
                                           {1e300, 0, 0},
                                           {NAN, 0, 0},
                                           {}}) {
    Answer wrong;
    wrong.emit("f", {1, 2, 3});
    wrong.emit("f/sizes", sizes);
    CHECK_FALSE(split_batch(wrong, 3));
  }
}

TEST_CASE("more fields than labs have are refused before they take memory") {
  Answer batch;
  for (int i = 0; i < 64; ++i) {
    batch.emit(fmt::format("f{}", i), {});
    batch.emit(fmt::format("f{}/sizes", i), {0});
  }
  CHECK(split_batch(batch, 1000));
  CHECK_FALSE(split_batch(batch, kMaxSplitFields / 64 + 1));
}

TEST_CASE("a right function has all classes right") {
  FakeRunner runner([](const Pair& pair, bool&) { return double(pair.a + pair.b); });
  CHECK_FALSE(judged(runner).first);
}

TEST_CASE("the input of a wrong answer becomes the simplest one that is wrong") {
  FakeRunner runner([](const Pair& pair, bool&) {
    return double(pair.a + pair.b) + (pair.a > 1000 && pair.b < -77 ? 1 : 0);
  });
  const CheckResult result = judged(runner);
  REQUIRE(result.first);
  CHECK(result.verdict == Verdict::kWrong);
  CHECK(result.first->choices == std::vector<std::uint64_t>{2001, 156});  // 1001 and -78
  REQUIRE(result.first->divergence);
  CHECK(result.first->divergence->expected == 1001 - 78);
  CHECK(result.first->divergence->actual == 1001 - 77);
  CHECK(result.first->where.find("the simplest generated input") != std::string::npos);
  CHECK(runner.runs < kMaxShrinkRuns);
}

TEST_CASE("the input of a crash or an exception is found among those of its class") {
  for (const bool throws : {false, true}) {
    FakeRunner crashing([](const Pair& pair, bool& crash) {
      crash = pair.a < -99'000;
      return double(pair.a + pair.b);
    });
    FakeRunner throwing([](const Pair& pair, bool&) {
      if (pair.a < -99'000) throw std::runtime_error("no");
      return double(pair.a + pair.b);
    });
    const CheckResult result = judged(throws ? throwing : crashing);
    REQUIRE(result.first);
    CHECK(result.verdict == (throws ? Verdict::kThrew : Verdict::kCrash));
    CHECK(result.first->choices == std::vector<std::uint64_t>{198'002});  // -99001 and 0
  }
}

TEST_CASE("the input of a crash or an exception becomes simple, too, in few runs") {
  FakeRunner crashing([](const Pair& pair, bool& crash) {
    crash = pair.a > 1000 && pair.b < -77;
    return double(pair.a + pair.b);
  });
  FakeRunner throwing([](const Pair& pair, bool&) {
    if (pair.a > 1000 && pair.b < -77) throw std::runtime_error("no");
    return double(pair.a + pair.b);
  });
  for (FakeRunner* runner : {&crashing, &throwing}) {
    const CheckResult result = judged(*runner);
    REQUIRE(result.first);
    CHECK(result.first->choices == std::vector<std::uint64_t>{2001, 156});  // 1001 and -78
    CHECK(runner->runs < kMaxShrinkRuns);
  }
}

TEST_CASE("wrong answers are found beside inputs that crash") {
  FakeRunner runner([](const Pair& pair, bool& crash) {
    crash = pair.a == 0 || pair.b == 0 || pair.a % 7 == 3;
    return double(pair.a + pair.b) + (pair.a > 1000 && pair.b < -77 ? 1 : 0);
  });
  const Check check = generated_check("sums", "1.1", "world", pairs, expect_sum);
  std::vector<Case> cases = check.cases();
  cases.resize(1);
  CheckResult result;
  result.name = "sums";
  result.first = FirstFailure{};
  result.first->choices = std::vector<std::uint64_t>{160'001, 150'000};
  shrink_failure(result, cases, runner, "", {});
  CHECK(result.first->where.find("the simplest generated input") != std::string::npos);
  CHECK(result.first->choices->at(0) < 2100);
  CHECK(result.first->choices->at(1) < 200);
}

TEST_CASE("a process that is out of time or does not start ends the search without a result") {
  for (const auto end : {RunOutcome::Ending::kTimeout, RunOutcome::Ending::kNotStarted}) {
    FakeRunner runner([](const Pair& pair, bool& crash) {
      crash = pair.a > 99'000;
      return double(pair.a + pair.b);
    });
    runner.bad_end = end;
    const CheckResult result = judged(runner);
    REQUIRE(result.first);
    CHECK(result.verdict == Verdict::kCrash);
    CHECK(result.first->where == "pairs");
    CHECK_FALSE(result.first->choices);
    CHECK(runner.runs < 30);
  }
}

TEST_CASE("a failure that does not repeat stays as it was") {
  static int calls;
  calls = 0;
  FakeRunner runner(
      [](const Pair& pair, bool&) { return double(pair.a + pair.b) + (++calls == 17 ? 1 : 0); });
  const CheckResult result = judged(runner);
  REQUIRE(result.first);
  CHECK(result.first->where.find("generated input 16; 1 of 3000") != std::string::npos);
}

TEST_CASE("a batch that is no list of hexadecimal digits is malformed") {
  for (const char* digits : {"0", "000000000000000g", "00000000000000000", "0000 00000000000"}) {
    CheckAnswers answers;
    answers.cases.resize(1);
    read_answers(fmt::format("{{\"case\": 0, \"fields\": {{\"f\": \"{}\"}}}}\n", digits), answers);
    CHECK(answers.cases[0].state == CaseAnswer::State::kMalformed);
  }
}
