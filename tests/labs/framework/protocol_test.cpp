// Tests reading what a runner writes, and what other code may have written in its place.
#include <cmath>
#include <string>

#include "labs/framework/compare.h"
#include "labs/framework/protocol.h"
#include "tests/support/catch.h"

using namespace glassbox::labs;
using State = CaseAnswer::State;

namespace {

CheckAnswers read(const std::string& lines, std::size_t cases = 2) {
  CheckAnswers answers;
  answers.cases.resize(cases);
  read_answers(lines, answers);
  return answers;
}

}  // namespace

TEST_CASE("a line gives the fields of its case, in any order of cases") {
  const auto answers = read(
      "{\"case\": 1, \"threw\": \"no\"}\n"
      "{\"case\": 0, \"fields\": {\"p\": [1, -2.5e-3, \"nan\", \"-inf\"], \"q\": []}}\n");
  REQUIRE(answers.cases[0].state == State::kAnswered);
  const auto* p = find_field(answers.cases[0].answer, "p");
  REQUIRE(p != nullptr);
  CHECK((*p)[1] == -2.5e-3);
  CHECK(std::isnan((*p)[2]));
  CHECK((*p)[3] < 0);
  CHECK(answers.cases[1].state == State::kThrew);
  CHECK(answers.cases[1].text == "no");
  CHECK(answers.malformed.empty());
}

TEST_CASE("lines that are no answers are told apart from missing ones") {
  for (const std::string line :
       {"hello", "[1]", "{}", "{\"case\": -1, \"fields\": {}}", "{\"case\": 2, \"fields\": {}}",
        "{\"case\": 1.5, \"fields\": {}}", "{\"case\": 1e300, \"fields\": {}}", "{\"case\": 0",
        "\"", "{\"case\": 18446744073709551616, \"fields\": {}}", "\xff\xfe"}) {
    CAPTURE(line);
    const auto answers = read(line + "\n");
    CHECK_FALSE(answers.malformed.empty());
    CHECK(answers.cases[0].state == State::kMissing);
  }
}

TEST_CASE("a bad answer costs its own case only") {
  for (const std::string body : {"\"fields\": {\"p\": [1, \"one\"]}", "\"fields\": {\"p\": 1}",
                                 "\"fields\": [1]", "\"fields\": {\"p\": [null]}", "\"threw\": 3",
                                 "\"other\": 1", "\"fields\": {}, \"threw\": \"both\""}) {
    CAPTURE(body);
    const auto answers =
        read("{\"case\": 0, " + body + "}\n{\"case\": 1, \"fields\": {\"p\": [1]}}\n");
    CHECK(answers.cases[0].state == State::kMalformed);
    CHECK(answers.cases[1].state == State::kAnswered);
  }
}

TEST_CASE("an answer with more fields than any lab has is refused") {
  for (const std::size_t count : {kMaxFields, kMaxFields + 1, std::size_t(100'000)}) {
    std::string fields;
    for (std::size_t i = 0; i < count; ++i)
      fields += (i > 0 ? ", \"" : "\"") + std::to_string(i) + "\": [1]";
    const auto state = count > kMaxFields ? State::kMalformed : State::kAnswered;
    CHECK(read("{\"case\": 0, \"fields\": {" + fields + "}}\n").cases[0].state == state);
    CHECK(read("{\"case\": 0, \"fields\": {}, \"sizes\": {" + fields + "}}\n").cases[0].state ==
          state);
  }
}

TEST_CASE("a case that is answered twice is answered by nobody") {
  const std::string line = "{\"case\": 0, \"fields\": {\"p\": [1]}}\n";
  CHECK(read(line + line).cases[0].state == State::kMalformed);
}

TEST_CASE("a line that a crash has cut off is no line") {
  const auto answers = read("{\"case\": 0, \"fields\": {}}\n{\"case\": 1, \"fie");
  CHECK(answers.cases[0].state == State::kAnswered);
  CHECK(answers.cases[1].state == State::kMissing);
  CHECK(answers.malformed.empty());
}

TEST_CASE("a tower of brackets is refused before it is built") {
  const auto answers = read("{\"case\": 0, \"fields\": " + std::string(1000000, '[') + "\n");
  CHECK_FALSE(answers.malformed.empty());
  CHECK(answers.cases[0].state == State::kMissing);
}

TEST_CASE("a megabyte of anything leaves the reader standing") {
  std::string noise;
  unsigned state = 1;
  for (int i = 0; i < 1000000; ++i) {
    state = state * 1664525u + 1013904223u;
    noise += char(state >> 24);
  }
  CHECK(read(noise).cases[0].state == State::kMissing);
}
