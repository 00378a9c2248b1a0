// A lab as its runner sees it, the program in which a student's code runs. It passes cases to the
// student's functions and writes what they return as data. It does not know the right answers; the
// judge (lab.h) is another process.
//
// Only headers of types are compiled into a runner, and nothing else of glassbox, so that it
// contains no reference solution that could be called.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "labs/framework/choices.h"

namespace glassbox::labs {

// The answer of a student's code to one case: named lists of numbers. A point is 3 or 4 numbers, a
// matrix 16 row by row, a polygon its vertices one after the other. A coverage (how often each
// pixel is covered) is one number for each pixel, row by row from the top.
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

// The entries of a matrix row by row, for an answer; or only those of its upper left part.
template <class Matrix>
std::vector<double> entries(const Matrix& m, int rows = 4, int columns = 4) {
  std::vector<double> all;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) all.push_back(m.at(i, j));
  }
  return all;
}

// A class of generated inputs (choices.h), which is one case of its check.
struct RunnerInputs {
  const char* what;
  int count;
  // Makes the input from the choices and calls the student's functions with it.
  std::function<void(Choices& choices, Answer& answer)> run;
};

// A check of the lab, as the runner sees it: `run` calls the student's functions with case number
// `index`. If the check has generated inputs, `generated` has its cases and `run` is not used.
struct RunnerCheck {
  std::string name;  // as Check::name of lab.h
  int cases = 0;
  std::function<void(int index, Answer& answer)> run = nullptr;
  std::vector<RunnerInputs> generated = {};
};

// A check that calls `ask` (which passes an input to the student's functions) for each of `inputs`.
template <class Input, class Ask>
RunnerCheck check(const char* name, const std::vector<Input>& inputs, Ask ask) {
  return {name, int(inputs.size()),
          [inputs, ask](int index, Answer& answer) { ask(inputs[std::size_t(index)], answer); }};
}

// A check with generated inputs: calls `ask` for each input of each class.
template <class Input, class Ask>
RunnerCheck generated_check(const char* name, const std::vector<InputClass<Input>>& classes,
                            Ask ask) {
  RunnerCheck check{name, int(classes.size())};
  for (const InputClass<Input>& each : classes)
    check.generated.push_back(
        {each.what, each.count, [make = each.make, ask](Choices& choices, Answer& answer) {
           ask(make(choices), answer);
         }});
  return check;
}

// Defined by the lab's runner.cpp.
std::vector<RunnerCheck> runner_checks();

}  // namespace glassbox::labs
