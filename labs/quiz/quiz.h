// The true/false questions of the slides, each with its answer, the reason, and points that show
// it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace glassbox::labs {

struct QuizQuestion {
  std::string statement;
  bool truth = false;
  std::string why;
  // the arguments of a glassbox command that shows why the statement is true, or a counterexample
  // if it is false
  std::string shown_by;
  // Whether the statement holds for every sample that it is tried with; the samples are computed by
  // the pipeline's own maps.
  std::function<bool()> holds;
};

struct Quiz {
  int lab = 0;
  std::string title;
  std::vector<QuizQuestion> questions;
};

// The quizzes of the labs that have one, in the order of the labs.
const std::vector<Quiz>& all_quizzes();

}  // namespace glassbox::labs
