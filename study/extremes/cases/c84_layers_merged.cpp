#include <numeric>

#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/layers.h"
#include "study/naive/layers.h"

namespace glassbox::study {
namespace c84 {

constexpr double kEpsilon = 0x1p-6;

// Returns the depths of one pixel that remain after merging, from back to front.
using Merge = std::function<std::vector<float>(const std::vector<float>& depths, double epsilon)>;

// Depths of which each is 0.9 epsilon behind the previous one: within epsilon of its neighbours,
// but not of the next but one.
std::vector<float> chain() {
  std::vector<float> depths;
  for (int i = 0; i < 12; ++i)
    depths.push_back(float(0.5 * std::pow(1 - 0.9 * kEpsilon, double(i))));
  return depths;
}

Outcome measure_error(const Merge& merge) {
  std::vector<float> depths = chain();
  // Counted from the front, the right result is the first depth, the third, and so on.
  std::vector<float> right;
  for (std::size_t i = depths.size(); i-- > 0;) {
    if (i % 2 == 0) right.push_back(depths[i]);
  }
  constexpr int kOrders = 200;
  int wrong = 0;
  std::size_t least = depths.size(), most = 0;
  Random random(84);
  for (int order = 0; order < kOrders; ++order) {
    const std::vector<float> left = merge(depths, kEpsilon);
    wrong += left != right;
    least = std::min(least, left.size());
    most = std::max(most, left.size());
    for (std::size_t i = depths.size(); i-- > 1;)
      std::swap(depths[i], depths[std::size_t(random.integer(0, int(i)))]);
  }
  return wrong_count_outcome(wrong, kOrders, "orders give other samples",
                             fmt::format("; {} to {} samples remain", least, most));
}

std::vector<float> ours(const std::vector<float>& depths, double epsilon) {
  views::LayerBuilder builder(layer_camera_of({.width = 1, .height = 1}), epsilon);
  for (const float depth : depths) builder.add(0, 0, depth, {9, 9, 9});
  return builder.pack().depth;
}

}  // namespace c84

ExtremeCase c84_layers_merged() {
  using namespace c84;
  return {
      .id = "C-84",
      .name = "A chain of near depths",
      .construction =
          "twelve samples of a pixel, each 0.9 epsilon behind the one in front of it, in 200 "
          "orders",
      .stage = "layers",
      .right_answer =
          "six samples remain in every order: from the front, each remaining sample absorbs those "
          "within epsilon behind it and no others",
      .unit = "orders",
      .oracle = Oracle::kProperty,
      .ours = {"samples are sorted, then merged from front to back",
               [] { return measure_error(ours); }},
      .naive = {"samples are merged in the order in which they come",
                [] { return measure_error(naive::merged_as_they_come); }},
      .mutants = {{"each sample is compared with the one in front of it, even if that one is "
                   "merged already",
                   [] { return measure_error(naive::merged_along_the_chain); }},
                  {"samples are merged from back to front",
                   [] { return measure_error(naive::merged_from_behind); }}},
      .not_drawn = "views/layers warps the samples; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
