// The slides' true/false questions, each with its answer, the reason, and points that show it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace glassbox::labs {

struct QuizQuestion {
  std::string statement;
  bool truth = false;
  std::string why;
  std::string
      shown_by;  // the words after "glassbox" of a command that shows it: a counterexample where the statement is false
  // Whether the statement held for every sample that it was put to, by the pipeline's own maps.
  std::function<bool()> holds;
};

struct Quiz {
  int lab = 0;
  std::string title;
  std::vector<QuizQuestion> questions;
};

// Of the labs that have one, in their order.
const std::vector<Quiz>& all_quizzes();

}  // namespace glassbox::labs
