// The true/false questions: every answer agrees with the pipeline's own transformations, and every
// command shows something.
#include <algorithm>
#include <string>

#include "labs/quiz/quiz.h"
#include "tests/support/catch.h"
#include "tests/support/run_program.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

test::Outcome run(const std::vector<std::string>& words) {
  return test::run_program(GLASSBOX_PROGRAM, words, "/");
}

std::string letters_of(const Quiz& quiz, bool inverted = false) {
  std::string letters;
  for (const QuizQuestion& question : quiz.questions)
    letters += question.truth != inverted ? 'T' : 'F';
  return letters;
}

}  // namespace

TEST_CASE(
    "a statement is true where it holds for every sample, and false where one contradicts it") {
  for (const Quiz& quiz : all_quizzes()) {
    REQUIRE(quiz.questions.size() >= 9);
    for (const QuizQuestion& question : quiz.questions) {
      CAPTURE(question.statement);
      CHECK(question.holds() == question.truth);
    }
  }
}

TEST_CASE("every answer of a quiz can be seen by a command") {
  for (const Quiz& quiz : all_quizzes()) {
    for (const QuizQuestion& question : quiz.questions) {
      CAPTURE(question.statement, question.shown_by);
      const auto shown = test::run_program(
          "/bin/sh", {"-c", std::string(GLASSBOX_PROGRAM) + " " + question.shown_by}, "/");
      CAPTURE(shown.err);
      CHECK(shown.exit_code <= 1);  // 1: a point is not in the picture
      CHECK(shown.err.empty());
      CHECK(shown.out.find("POINT (") != std::string::npos);
    }
  }
}

TEST_CASE("lab quiz lists the statements, explains what is wrong, and says how many are right") {
  for (const Quiz& quiz : all_quizzes()) {
    const std::string lab = std::to_string(quiz.lab);
    const auto listed = run({"lab", "quiz", lab});
    CHECK(listed.exit_code == 0);
    CHECK(listed.out.find(quiz.questions.back().statement) != std::string::npos);
    CHECK(listed.out.find(quiz.questions.back().why) == std::string::npos);
    CHECK(run({"lab", "quiz", lab, "--answers"}).out.find(quiz.questions.back().why) !=
          std::string::npos);

    CHECK(run({"lab", "quiz", lab, letters_of(quiz)}).exit_code == 0);
    const auto wrong = run({"lab", "quiz", lab, letters_of(quiz, true)});
    CHECK(wrong.exit_code == 1);
    CHECK(wrong.out.find("0 of " + std::to_string(quiz.questions.size()) + " answers are right") !=
          std::string::npos);
    CHECK(run({"lab", "quiz", lab, "TX"}).exit_code == 2);
    CHECK(run({"lab", "quiz", lab, ""}).exit_code == 2);
  }
  CHECK(run({"lab", "quiz", "5"}).exit_code == 2);
}
