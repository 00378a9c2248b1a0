#include <glassbox/pipeline/stereo/parallax_budget.h>

#include "study/extremes/common/extreme_case.h"
#include "study/naive/stereo.h"

namespace glassbox::study {
namespace c79 {

constexpr double kFrames = 15;

// Takes the requested distance of the stereo window, frame after frame, and returns the distance
// that is used.
using Filter = std::function<double(double)>;

// The window's distance f goes from 10 to 1, then back, in 120 frames each. The parallax at
// infinity is proportional to 1/f, so the error is the largest change of 1/f between two frames, as
// a fraction of the whole step. A change in the wrong direction or beyond the goal counts as a
// jump, which is the whole step.
Outcome measure_error(const std::function<Filter()>& make) {
  const Filter next = make();
  double worst = 0, backwards = 0;
  double last = 1 / next(10);
  for (const double window : {1.0, 10.0}) {
    const double goal = 1 / window, step = 1 - 0.1;
    const double direction = goal > last ? 1 : -1;
    for (int frame = 0; frame < 120; ++frame) {
      const double inverse = 1 / next(window);
      const double moved = (inverse - last) * direction / step;
      worst = std::max(worst, moved);
      backwards = std::max({backwards, -moved, (inverse - goal) * direction / step});
      last = inverse;
    }
  }
  // Smaller differences than 1e-15 are rounding errors of 1/(1/f).
  const bool monotone = backwards <= 1e-15;
  return {monotone ? worst : std::max(worst, 1.0),
          low_pass_weight(kFrames) * (1 + 1e-12),
          {},
          monotone ? fmt::format("parallax moves by {:.4f} of the step in one frame", worst)
                   : fmt::format("parallax moves by {:.4f} of the step in one frame, and by {:.4f} "
                                 "in the wrong direction",
                                 worst, backwards)};
}

}  // namespace c79

ExtremeCase c79_window_step() {
  using namespace c79;
  return {
      .id = "C-79",
      .name = "The window jumps",
      .construction =
          "the stereo window from 10 to 1, and back after 120 frames; a time constant of 15 frames",
      .stage = "stereo",
      .right_answer =
          "parallax changes in one direction only, and in no frame by more than 1/16 of the step "
          "(1/(1 + 15))",
      .unit = "of the step per frame",
      .oracle = Oracle::kAnalytic,
      .ours = {"a low-pass filter of 1/f",
               [] {
                 return measure_error([] {
                   return [filter = WindowFilter(kFrames)](double f) mutable {
                     return filter.next(f);
                   };
                 });
               }},
      .naive = {"the window's distance is not smoothed",
                [] { return measure_error([] { return [](double f) { return f; }; }); }},
      .mutants = {{"a low-pass filter of f",
                   [] {
                     return measure_error([] {
                       return [filter = naive::FilterOfDistance(kFrames)](double f) mutable {
                         return filter.next(f);
                       };
                     });
                   }},
                  {"a spring that overshoots",
                   [] {
                     return measure_error([] {
                       return
                           [spring = naive::Spring()](double f) mutable { return spring.next(f); };
                     });
                   }}},
      .not_drawn =
          "the case tests how parallax changes from frame to frame; one frame alone is an ordinary "
          "stereo pair (C-70)",
  };
}

}  // namespace glassbox::study
