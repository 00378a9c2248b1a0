// As much depth as the eyes can bear (S0-13, "puke factor control"): the separation that keeps parallax within a
// budget, and its changes from frame to frame.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// Stereo photography's rule of one in thirty: the distance between the eyes is a thirtieth of the
// distance to the nearest thing. Here it is a thirtieth of the distance to the window.
inline constexpr double kWindowsPerSeparation = 30;

// What is seen of the scene, world units along the gaze. Perspective: 0 < nearest <= farthest, which may be infinite;
// parallel: finite.
struct DepthSpan {
  double nearest = 1, farthest = std::numeric_limits<double>::infinity();
};

// The largest |parallax| in front of the window and behind it, px >= 0.
struct ParallaxBudget {
  double in_front_px = 0, behind_px = 0;
};

// Says what is wrong with a span or a budget, and with a span that reaches behind the camera.
Result<void> check_comfort(const View& centre, const DepthSpan& span, const ParallaxBudget& budget);

// The s* of S0-13, min(P-/(2k (1/zn - 1/f)), P+/(2k (1/f - 1/zf)), at_most) with k = (W/2)(d/h), or with the linear
// law of parallel projections: the most depth within the budget, and never more than check_pair allows. A few u less
// than the quotient, so that parallax_at of it is never beyond the budget.
double largest_half_separation(const View& centre, double window, const DepthSpan& span,
                               const ParallaxBudget& budget,
                               double at_most = std::numeric_limits<double>::infinity());

// The window that lets the separation be largest: both ends of the span reach the budget. 1/f = (P+/zn + P-/zf)/(P- +
// P+), the harmonic mean where the budget is symmetric; for parallel projections f = (P+ zn + P- zf)/(P- + P+). No
// budget at all counts as symmetric. Infinite where nothing may be behind the window and the span is infinite.
double best_window(const View& centre, const DepthSpan& span, const ParallaxBudget& budget);

// ---- over time ----

// The share of the way to its goal that a first-order low-pass goes in one frame: 1/(1 + frames), the backward Euler step
// of the time constant `frames`, which needs no exponential. 1 for frames = 0.
double low_pass_share(double frames);

// Frame after frame, without knowledge of the future. Two promises:
//   - never above the limit: the budget is what the eyes bear, so a falling limit is followed at once (fast attack).
//     A falling step is as large as the limit's own fall asks for, no larger; only a look ahead (smooth_separations)
//     spreads it.
//   - a rising limit is approached by the low-pass (slow release): monotone, without overshoot, and no step is longer
//     than low_pass_share(release_frames) of the way left.
// The first frame starts at its limit.
class SeparationFilter {
public:
  explicit SeparationFilter(double release_frames) : share_(low_pass_share(release_frames)) {}
  double next(double limit);

private:
  double share_;
  double current_ = std::numeric_limits<double>::quiet_NaN();  // before the first frame
};

// The same for a window that jumps (C-79): parallax is linear in 1/f, which is what the low-pass works on. Monotone,
// without overshoot, and always between the windows that were asked for.
class WindowFilter {
public:
  explicit WindowFilter(double frames) : share_(low_pass_share(frames)) {}
  double next(double window);

private:
  double share_;
  double current_ = std::numeric_limits<double>::quiet_NaN();  // 1/f
};

// SeparationFilter with its limits known beforehand. Never above a limit, and no two neighbours differ by more than
// `max_step` > 0 (up to the rounding of one addition): where a limit falls, the separation begins to fall in time,
// along a straight line.
std::vector<double> smooth_separations(std::span<const double> limits, double release_frames,
                                       double max_step = std::numeric_limits<double>::infinity());

// ---- a sequence of pictures ----

struct ComfortFrame {
  View centre;
  DepthSpan span;
  double window = 1;  // where it should be; kept within the near and far planes
};

struct ComfortRates {
  double window_frames = 15, release_frames = 15;
  double max_step = std::numeric_limits<double>::infinity();  // of half the separation, per frame
  double at_most = std::numeric_limits<double>::infinity();   // half the separation
};

// A pair for each frame: the windows smoothed first, then the largest separations for those, smoothed. Every frame is
// within the budget; |change of half_separation| <= max_step.
std::vector<StereoPair> comfortable_pairs(std::span<const ComfortFrame> frames,
                                          const ParallaxBudget& budget, const ComfortRates& rates);

}  // namespace glassbox
