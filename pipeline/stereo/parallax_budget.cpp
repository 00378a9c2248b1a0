#include <glassbox/pipeline/stereo/parallax_budget.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/number_text.h>
#include <glassbox/pipeline/stereo/parallax.h>

namespace glassbox {

Result<void> check_parallax_budget(const View& centre, const DepthSpan& span,
                                   const ParallaxBudget& budget) {
  const std::string ends = number_text(span.nearest) + " to " + number_text(span.farthest);
  if (!(span.nearest <= span.farthest) || std::isinf(span.nearest)) {
    return fail("depth range", "it is " + ends, "give the nearest distance first");
  }
  if (centre.perspective && !(span.nearest > 0)) {
    return fail("depth range", "it is " + ends + ", which begins behind the camera",
                "begin at the near plane, " + number_text(centre.near));
  }
  if (!centre.perspective && std::isinf(span.farthest)) {
    return fail("depth range",
                "it is " + ends + ", and parallax grows without limit in a parallel projection",
                "give a finite range");
  }
  for (const double px : {budget.in_front_px, budget.behind_px}) {
    if (px >= 0 && std::isfinite(px)) continue;
    return fail("parallax budget", "it is " + number_text(px) + " pixels",
                "give a number of pixels, 0 or more");
  }
  return {};
}

double largest_half_separation(const View& centre, double window, const DepthSpan& span,
                               const ParallaxBudget& budget, double at_most) {
  // Parallax is proportional to the separation and increases with the distance, so the two ends of
  // the span decide.
  const StereoPair unit{1, window};
  const double in_front = -parallax_at(centre, unit, span.nearest).px;
  const double behind = parallax_at(centre, unit, span.farthest).px;
  double s = std::min(at_most, window_half_width(centre, window));
  const double bound = s;
  if (in_front > 0) s = std::min(s, budget.in_front_px / in_front);
  if (behind > 0) s = std::min(s, budget.behind_px / behind);
  // The result is reduced by 12 roundings: parallax_at rounds a product of five factors, here and
  // when the caller calls it again, and the quotient rounds too.
  return s == bound ? s : s * (1 - 12 * unit_roundoff<double>);
}

double best_window(const View& centre, const DepthSpan& span, const ParallaxBudget& budget) {
  const double total = budget.in_front_px + budget.behind_px;
  const double front = total > 0 ? budget.in_front_px / total : 0.5;
  const double behind = total > 0 ? budget.behind_px / total : 0.5;
  const double window = centre.perspective ? 1 / (behind / span.nearest + front / span.farthest)
                                           : behind * span.nearest + front * span.farthest;
  return std::clamp(window, span.nearest, span.farthest);  // rounding may have moved it outside
}

double low_pass_weight(double frames) {
  return 1 / (1 + frames);
}

double SeparationFilter::next(double limit) {
  if (!(current_ < limit)) {
    current_ = limit;
  } else {
    current_ = std::min(current_ + share_ * (limit - current_), limit);
  }
  return current_;
}

double WindowFilter::next(double window) {
  const double goal = 1 / window;
  if (std::isnan(current_)) current_ = goal;
  const double moved = current_ + share_ * (goal - current_);
  current_ = goal < current_ ? std::max(moved, goal) : std::min(moved, goal);
  return 1 / current_;
}

std::vector<double> smooth_separations(std::span<const double> limits, double release_frames,
                                       double max_step) {
  // Backwards in time: the value of a frame is at most one step above that of the next frame.
  std::vector<double> reachable(limits.begin(), limits.end());
  for (std::size_t i = reachable.size(); i-- > 1;) {
    reachable[i - 1] = std::min(reachable[i - 1], reachable[i] + max_step);
  }
  // Forwards in time: rises are filtered. No fall is longer than a step, because the separation
  // before was at most its reachable value, which is at most one step above this frame's.
  std::vector<double> separations;
  separations.reserve(limits.size());
  const double share = low_pass_weight(release_frames);
  for (const double limit : reachable) {
    const double last = separations.empty() ? limit : separations.back();
    const double rise = std::min(share * (limit - last), max_step);
    separations.push_back(limit <= last ? limit : std::min(last + rise, limit));
  }
  return separations;
}

std::vector<StereoPair> smoothed_stereo_pairs(std::span<const StereoFrame> frames,
                                              const ParallaxBudget& budget,
                                              const SmoothingOptions& rates) {
  std::vector<StereoPair> pairs;
  std::vector<double> limits;
  WindowFilter windows(rates.window_frames);
  for (const StereoFrame& frame : frames) {
    const double window =
        std::clamp(windows.next(frame.window), frame.centre.near, frame.centre.far);
    pairs.push_back({0, window});
    limits.push_back(
        largest_half_separation(frame.centre, window, frame.span, budget, rates.at_most));
  }
  const std::vector<double> separations =
      smooth_separations(limits, rates.release_frames, rates.max_step);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].half_separation = separations[i];
  return pairs;
}

}  // namespace glassbox
