#include <functional>

#include <Eigen/LU>

#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "views/texture/view_blend.h"

namespace glassbox::study {
namespace c98 {

using views::Vector3d;
using views::ViewBlend;
using views::ViewWeights;
using VisibilityTest = std::function<bool(std::size_t view)>;
using Weights = std::function<ViewWeights(const Vector3d& direction, const VisibilityTest& sees)>;

// Directions of views: the corners of an octahedron and the centres of its faces, so that
// directions on the sides of the triangles between them are exact.
const std::vector<Vector3d>& directions() {
  static const std::vector<Vector3d> all = [] {
    std::vector<Vector3d> made;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) made.push_back(sign * Vector3d::Unit(axis));
    }
    for (int corner = 0; corner < 8; ++corner)
      made.push_back(Vector3d((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                              (corner & 4) != 0 ? 1 : -1)
                         .normalized());
    return made;
  }();
  return all;
}

const ViewBlend& blend() {
  static const ViewBlend made(views::Blend::kBarycentric, directions());
  return made;
}

// Directions inside the triangles, on their edges and at their corners.
std::vector<Vector3d> asked(Random& random) {
  std::vector<Vector3d> all = directions();
  for (const auto& t : blend().sphere().triangles()) {
    const Vector3d &a = directions()[t[0]], &b = directions()[t[1]], &c = directions()[t[2]];
    for (const double share : {0.5, 0.25, 1e-3, 1e-9}) {
      all.push_back((share * a + (1 - share) * b).normalized());
      all.push_back((share * a + share * b + c).normalized());
    }
    const double of_a = random.between(0.1, 1), of_b = random.between(0.1, 1);
    all.push_back((of_a * a + of_b * b + c).normalized());
  }
  return all;
}

// Four rounding errors for each of at most three weights, and those of their sums, are less than
// this.
constexpr double kBound = 0x1p-50;

Outcome measure_error(const Weights& weights) {
  Random random(98);
  WorstError worst;
  for (const Vector3d& direction : asked(random)) {
    // On average, one of this many views sees the polygon.
    for (const int share : {1, 2, 4, 8, 1000}) {
      std::vector<bool> seen(directions().size());
      for (std::size_t v = 0; v < seen.size(); ++v) seen[v] = random.integer(0, share - 1) == 0;
      const bool by_anybody = std::ranges::find(seen, true) != seen.end();
      const ViewWeights found = weights(direction, [&](std::size_t v) { return bool(seen[v]); });
      double sum = 0, error = 0;
      for (const views::ViewWeight& each : found) {
        sum += each.weight;
        // A view that does not see the polygon must have no weight, and no weight may be negative.
        if (!seen[each.view] || !(each.weight >= 0)) error = 1;
      }
      error = std::max(error, std::abs(sum - (by_anybody ? 1 : 0)));
      if (std::isnan(sum)) error = sum;
      worst.add(error, kBound,
                fmt::format("the weights add up to {} if {} of {} views see the polygon",
                            std::isnan(sum) ? "NaN" : fmt::format("{:.6g}", sum),
                            std::ranges::count(seen, true), seen.size()));
    }
  }
  return worst.outcome();
}

ViewWeights ours(const Vector3d& direction, const VisibilityTest& sees) {
  return blend().from_direction(direction).weights(sees);
}

// The steps of the method; mutants leave out some of them.
struct Steps {
  bool leaves_out_unseen = true, divides = true, falls_back = true, has_empty_sum = false;
};

ViewWeights by_steps(const Vector3d& direction, const VisibilityTest& sees, const Steps& steps) {
  ViewWeights weights = blend().sphere().weights(direction);
  double sum = 0;
  for (views::ViewWeight& each : weights) {
    if (steps.leaves_out_unseen && !sees(each.view)) each.weight = 0;
    sum += each.weight;
  }
  if (!steps.has_empty_sum && sum == 0)
    return steps.falls_back ? ours(direction, sees) : ViewWeights();
  for (views::ViewWeight& each : weights) {
    if (steps.divides) each.weight /= sum;
  }
  std::erase_if(weights, [](const views::ViewWeight& each) { return each.weight == 0; });
  return weights;
}

Outcome measure_step_error(const Steps& steps) {
  return measure_error([steps](const Vector3d& direction, const VisibilityTest& sees) {
    return by_steps(direction, sees, steps);
  });
}

}  // namespace c98

ExtremeCase c98_views_that_see_nothing() {
  using namespace c98;
  return {
      .id = "C-98",
      .name = "Views that do not see the polygon",
      .construction =
          "14 views; directions of these views, on the sides of their triangles and inside; "
          "polygons that all, some or none of the views see",
      .stage = "texture",
      .right_answer =
          "only views that see the polygon have weights, none below 0, with the sum 1; there are "
          "no weights if no view sees it (S1-40)",
      .unit = "weight",
      .oracle = Oracle::kAnalytic,
      .ours = {"views that do not see the polygon are left out, and the other weights are divided "
               "by their sum; if none is left, the nearest view that sees it gets the weight 1",
               [] { return measure_error(ours); }},
      .naive = {"the weights are divided by the sum of the remaining ones, even if it is 0",
                [] { return measure_step_error({.has_empty_sum = true}); }},
      .mutants = {{"the weights are not divided by their new sum",
                   [] { return measure_step_error({.divides = false}); }},
                  {"views that do not see it keep their weights",
                   [] { return measure_step_error({.leaves_out_unseen = false}); }},
                  {"no other view is used if none of the three sees the polygon",
                   [] { return measure_step_error({.falls_back = false}); }}},
      .not_drawn = "views/texture computes the weights; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
