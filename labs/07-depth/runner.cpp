// Calls your functions with the cases of lab 7.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_07 {
namespace {

using glassbox::labs::Answer;

void ask_row(const Planes& input, Answer& answer) {
  const DepthRow row = depth_row(input.near, input.far, input.range);
  answer.emit("a", {row.a});
  answer.emit("b", {row.b});
}

void ask_distance(const DistanceCase& input, Answer& answer) {
  for (std::size_t i = 0; i < input.depths.size(); ++i) {
    const Planes& p = input.planes;
    answer.emit("distance " + std::to_string(i),
                {distance_of(input.depths[i], p.near, p.far, p.range)});
  }
}

void ask_code(const CodeCase& input, Answer& answer) {
  std::vector<double> codes;
  for (const float depth : input.depths) codes.push_back(depth_code(input.format, depth));
  answer.emit("codes", codes);
}

void ask_visible(const BufferCase& input, Answer& answer) {
  const std::vector<int> seen = visible(input.fragments, input.pixels, input.format);
  answer.emit("seen", {seen.begin(), seen.end()});
}

void ask_ladder(const LadderCase& input, Answer& answer) {
  for (std::size_t i = 0; i < input.distances.size(); ++i)
    answer.emit("rung " + std::to_string(i),
                {separation(input.format, input.near, input.far, input.distances[i])});
}

}  // namespace
}  // namespace lab_07

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_07;
  return {
      check("the near and far planes have the ends of the range", planes(), ask_row),
      check("a depth leads back to its distance", depths(), ask_distance),
      check("depths become codes", codes(), ask_code),
      check("the nearest fragment is seen, the first of equals", buffers(), ask_visible),
      check("the ladder of the formats", ladders(), ask_ladder),
      generated_check("any two planes", generated_planes(), ask_row),
      generated_check("any depth", generated_depths(), ask_distance),
      generated_check("any depth to a code", generated_codes(), ask_code),
      generated_check("any fragments", generated_buffers(), ask_visible),
      generated_check("any rung", generated_ladders(), ask_ladder),
      // BEGIN HIDDEN
      check("planes very close and very far apart", more_planes(), ask_row),
      check("depths next to the far plane's", more_depths(), ask_distance),
      check("random depths and halves", more_codes(), ask_code),
      check("many fragments", more_buffers(), ask_visible),
      check("ladders of other views", more_ladders(), ask_ladder),
      // END HIDDEN
  };
}
