#include "cases.h"
#include "student.h"

#include "labs/framework/runner.h"

namespace glassbox::labs {

std::vector<RunnerCheck> runner_checks() {
  return {
      check("twice a number", inputs(), [](double x, Answer& a) { a.emit("y", {twice(x)}); }),
      check("a reciprocal", inputs(), [](double x, Answer& a) { a.emit("y", {reciprocal(x)}); }),
      // BEGIN HIDDEN
      check("a reciprocal undone", hidden_inputs(),
            [](double x, Answer& a) { a.emit("y", {reciprocal(reciprocal(x))}); }),
      // END HIDDEN
  };
}

}  // namespace glassbox::labs
