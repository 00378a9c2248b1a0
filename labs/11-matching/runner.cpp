// Calls your functions with the inputs of lab 11.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_11 {
namespace {

using glassbox::labs::Answer;

std::vector<double> numbers(const std::vector<int>& values) {
  return {values.begin(), values.end()};
}

void square(const SadCase& input, Answer& answer) {
  std::vector<double> sums;
  for (const Place& p : input.places)
    sums.push_back(sad(input.left, input.right, p.x, p.y, p.d, input.radius));
  answer.emit("sums", sums);
}

void word(const CensusCase& input, Answer& answer) {
  std::vector<double> words;
  for (const Place& p : input.places) words.push_back(census(input.picture, p.x, p.y));
  answer.emit("words", words);
}

void bits(const HammingCase& input, Answer& answer) {
  answer.emit("bits", {double(hamming(input.a, input.b))});
}

void path(const PathCase& input, Answer& answer) {
  answer.emit("sums", numbers(along_path(input.costs, input.disparities, input.p1, input.p2)));
}

void best(const WinnerCase& input, Answer& answer) {
  answer.emit("disparity", {winner(input.costs)});
}

void row(const RowCase& input, Answer& answer) {
  answer.emit("disparities", right_winners(input.costs, input.width, input.disparities));
}

void confirmed(const CheckCase& input, Answer& answer) {
  answer.emit("disparities", left_right_check(input.left, input.right, input.tolerance));
}

void distance(const DepthCase& input, Answer& answer) {
  answer.emit("depth", {depth(input.disparity, input.calibration)});
}

}  // namespace
}  // namespace lab_11

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_11;
  return {
      check("how unlike two squares are", squares(), square), check("census words", words(), word),
      check("bits that differ", pairs_of_words(), bits), check("costs along a path", paths(), path),
      check("the disparity that costs least", winners(), best),
      check("what the right pixels win", rows(), row),
      check("what both pictures agree on", pairs_of_rows(), confirmed),
      check("how far away it is", depths(), distance),
      generated_check("any square", generated_squares(), square),
      generated_check("any pixel", generated_words(), word),
      generated_check("any two words", generated_pairs_of_words(), bits),
      generated_check("any path", generated_paths(), path),
      generated_check("any costs", generated_winners(), best),
      generated_check("any row", generated_rows(), row),
      generated_check("any two rows", generated_pairs_of_rows(), confirmed),
      generated_check("any depth", generated_depths(), distance),
      // BEGIN HIDDEN
      check("other squares", hidden_squares(), square),
      check("other census words", hidden_words(), word),
      check("bits of other words", hidden_pairs_of_words(), bits),
      check("other paths", hidden_paths(), path), check("other costs", hidden_winners(), best),
      check("other right pixels", hidden_rows(), row),
      check("rows of another pair", hidden_pairs_of_rows(), confirmed),
      check("other disparities", hidden_depths(), distance),
      // END HIDDEN
  };
}
