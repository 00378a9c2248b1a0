// glassbox lab quiz: asks the slides' true/false questions and explains what is wrong with an
// answer.
#include <algorithm>
#include <cctype>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "cli/report/exit_codes.h"
#include "labs/commands/commands.h"
#include "labs/commands/find_lab.h"
#include "labs/quiz/quiz.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::labs {

class LabQuizCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string lab_;
  std::optional<std::string> answers_;
  bool show_ = false;
};

namespace {

Result<const Quiz*> find_quiz(const std::string& name) {
  const auto lab = find_lab(name);
  if (!lab) return tl::unexpected(lab.error());
  std::string numbers;
  for (const Quiz& quiz : labs::all_quizzes()) {
    if (quiz.lab == (*lab)->number) return &quiz;
    numbers += (numbers.empty() ? "" : " and ") + std::to_string(quiz.lab);
  }
  return fail("lab " + name, "this lab has no quiz", "the labs with a quiz are " + numbers);
}

const char* word_of(bool truth) {
  return truth ? "true" : "false";
}

void print_answer(std::size_t number, const QuizQuestion& question) {
  fmt::print("{:>4}  {}\n      {}. {}\n      glassbox {}\n", number, question.statement,
             question.truth ? "True" : "False", question.why, question.shown_by);
}

// Reads the answers, one letter (T or F) for each question. Anything else is an error.
Result<std::vector<bool>> answers_of(const std::string& letters, const Quiz& quiz) {
  std::vector<bool> answers;
  for (const char letter : letters) {
    const int upper = std::toupper(static_cast<unsigned char>(letter));
    if (upper == 'T' || upper == 'F') answers.push_back(upper == 'T');
  }
  if (answers.size() == letters.size() && answers.size() == quiz.questions.size()) return answers;
  return fail(
      "ANSWERS",
      fmt::format("{} is not a list of {} answers", in_quotes(letters), quiz.questions.size()),
      "give one T or F for each statement, in their order, without spaces");
}

int grade(const Quiz& quiz, const std::vector<bool>& answers) {
  std::size_t right = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const QuizQuestion& question = quiz.questions[i];
    if (answers[i] == question.truth) {
      ++right;
    } else {
      fmt::print("Your answer \"{}\" is wrong:\n", word_of(answers[i]));
      print_answer(i + 1, question);
    }
  }
  fmt::print("{} of {} answers {} right\n", right, answers.size(),
             singular_or_plural(right, "is", "are"));
  return right == answers.size() ? kSuccess : kFailure;
}

}  // namespace

void LabQuizCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand(
      "quiz", "asks which statements of the slides on a lab's subject are true");
  command.footer(
      "Examples:\n"
      "  glassbox lab quiz 2              # the statements\n"
      "  glassbox lab quiz 2 TTTTTTTTT    # your answers; the wrong ones are explained, with a "
      "command to try\n"
      "  glassbox lab quiz 4 --answers    # all answers\n\n"
      "The exit code is 0 if all answers are right, and 1 if one is wrong.");
  command.add_option("LAB", lab_, "2 (affine maps) or 4 (perspective)")->required();
  command.add_option("ANSWERS", answers_, "T or F for each statement, in their order");
  command.add_flag("--answers", show_,
                   "show all answers, with reasons and commands that show them");
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabQuizCommand::run() const {
  const auto quiz = find_quiz(lab_);
  if (!quiz) return refuse(quiz.error());
  if (answers_) {
    const auto answers = answers_of(*answers_, **quiz);
    return answers ? grade(**quiz, *answers) : refuse(answers.error());
  }
  fmt::print("{}: true or false?\n\n", (*quiz)->title);
  for (std::size_t i = 0; i < (*quiz)->questions.size(); ++i) {
    const QuizQuestion& question = (*quiz)->questions[i];
    if (show_) {
      print_answer(i + 1, question);
    } else {
      fmt::print("{:>4}  {}\n", i + 1, question.statement);
    }
  }
  if (!show_)
    fmt::print("\nglassbox lab quiz {} {} answers \"true\" to all of them.\n", (*quiz)->lab,
               std::string((*quiz)->questions.size(), 'T'));
  return kSuccess;
}

void add_quiz_command(CLI::App& lab, int& exit_code) {
  add_command<LabQuizCommand>(lab, exit_code);
}

}  // namespace glassbox::labs
