// The side of a lab on which a student's code runs: it puts cases to the student's functions and emits what they return, as
// data. What is right is not known here; the judge (lab.h) is another process.
//
// Nothing of glassbox but headers of types is compiled into a runner, so that there is no reference in it to call.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace glassbox::labs {

// What a student's code answered to one case: named lists of numbers. A point is 3 or 4 of them, a matrix 16 row by row, a
// polygon its vertices one after the other, coverage one number for each pixel row by row from the top.
class Answer {
public:
  struct Field {
    std::string name;
    std::vector<double> values;
  };
  void emit(const std::string& name, std::vector<double> values) {
    fields_.push_back({name, std::move(values)});
  }
  const std::vector<Field>& fields() const { return fields_; }

private:
  std::vector<Field> fields_;
};

// The entries of a matrix row by row, as answers have them; of its upper left part where fewer are asked for.
template <class Matrix>
std::vector<double> entries(const Matrix& m, int rows = 4, int columns = 4) {
  std::vector<double> all;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) all.push_back(m.at(i, j));
  }
  return all;
}

// A check of the lab, as the runner sees it: `run` puts case number `index` to the student's functions.
struct RunnerCheck {
  std::string name;  // as Check::name of lab.h
  int cases = 0;
  std::function<void(int index, Answer& answer)> run;
};

// A check that puts each of `inputs` to `ask`.
template <class Input, class Ask>
RunnerCheck check(const char* name, const std::vector<Input>& inputs, Ask ask) {
  return {name, int(inputs.size()),
          [inputs, ask](int index, Answer& answer) { ask(inputs[std::size_t(index)], answer); }};
}

// Defined by the lab's runner.cpp.
std::vector<RunnerCheck> runner_checks();

}  // namespace glassbox::labs
