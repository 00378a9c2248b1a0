// Chooses the eye separation so that there is as much depth as is comfortable for the eyes (S0-13,
// "puke factor control"): it keeps parallax within a budget, and it changes smoothly from frame to
// frame.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// The one-in-thirty rule of stereo photography: the distance between the eyes is a thirtieth of the
// distance to the nearest object. Here it is a thirtieth of the distance to the window.
inline constexpr double kWindowsPerSeparation = 30;

// The range of distances of what is seen of the scene, world units along the gaze. Perspective: 0 <
// nearest <= farthest, which may be infinite; parallel: finite.
struct DepthSpan {
  double nearest = 1, farthest = std::numeric_limits<double>::infinity();
};

// The largest |parallax| allowed in front of the window and behind it, px >= 0.
struct ParallaxBudget {
  double in_front_px = 0, behind_px = 0;
};

// Reports what is wrong with a span or a budget, and with a span that extends behind the camera.
Result<void> check_parallax_budget(const View& centre, const DepthSpan& span,
                                   const ParallaxBudget& budget);

// The largest half separation s within the budget, and never more than check_pair allows (s* of
// S0-13): min(P-/(2k (1/zn - 1/f)), P+/(2k (1/f - 1/zf)), at_most), where P- and P+ are the budgets
// in front and behind, zn and zf the ends of the span, f the window's distance and k = (W/2)(d/h)
// the pixels per unit of x/z. Parallel projections have the linear formula of parallax.h. The
// result is a few units of roundoff less than the quotient, so that its parallax_at is never beyond
// the budget.
double largest_half_separation(const View& centre, double window, const DepthSpan& span,
                               const ParallaxBudget& budget,
                               double at_most = std::numeric_limits<double>::infinity());

// The distance f of the window for which the separation can be largest: both ends of the span reach
// the budget. With the letters of largest_half_separation, 1/f = (P+/zn + P-/zf)/(P- + P+), the
// harmonic mean of zn and zf where the budget is symmetric; for parallel projections f = (P+ zn +
// P- zf)/(P- + P+). A budget of 0 on both sides is treated as symmetric. The result is infinite
// where nothing may be behind the window and the span is infinite.
double best_window(const View& centre, const DepthSpan& span, const ParallaxBudget& budget);

// ---- over time ----

// The fraction of the difference from the goal that a first-order low-pass filter removes in one
// frame: 1/(1 + frames), the backward Euler step of the time constant `frames`, which needs no
// exponential. 1 for frames = 0.
double low_pass_weight(double frames);

// Filters the separation frame by frame, without knowing later frames. Two guarantees:
//   - It is never above the limit: the budget is what the eyes can bear, so a falling limit is
//     followed at once (fast attack). A falling step is as large as the limit's own fall requires,
//     no larger; only knowledge of later frames (smooth_separations) can spread it.
//   - A rising limit is approached by the low-pass filter (slow release): monotonically, without
//     overshoot, and no step is longer than low_pass_weight(release_frames) of the distance to it.
// The first frame starts at its limit.
class SeparationFilter {
public:
  explicit SeparationFilter(double release_frames) : share_(low_pass_weight(release_frames)) {}
  double next(double limit);

private:
  double share_;
  double current_ = std::numeric_limits<double>::quiet_NaN();  // before the first frame
};

// Filters the window's distance, frame by frame, so that a jump of it becomes smooth (C-79).
// Parallax is linear in 1/f, so the low-pass filter works on 1/f. The result is monotone, without
// overshoot, and always between the requested windows.
class WindowFilter {
public:
  explicit WindowFilter(double frames) : share_(low_pass_weight(frames)) {}
  double next(double window);

private:
  double share_;
  double current_ = std::numeric_limits<double>::quiet_NaN();  // 1/f
};

// Like SeparationFilter, with all limits known in advance. The results are never above a limit, and
// those of two neighbouring frames never differ by more than `max_step` > 0 (up to the rounding of
// one addition): where a limit falls, the separation begins to fall early enough, along a straight
// line.
std::vector<double> smooth_separations(std::span<const double> limits, double release_frames,
                                       double max_step = std::numeric_limits<double>::infinity());

// ---- a sequence of pictures ----

struct StereoFrame {
  View centre;
  DepthSpan span;
  double window = 1;  // requested distance; clamped to the near and far planes
};

struct SmoothingOptions {
  double window_frames = 15, release_frames = 15;
  double max_step = std::numeric_limits<double>::infinity();  // change of half_separation per frame
  double at_most = std::numeric_limits<double>::infinity();   // largest half_separation
};

// One pair for each frame: the windows are smoothed first, then the largest separations for those
// windows are smoothed. Every frame is within the budget; |change of half_separation| <= max_step.
std::vector<StereoPair> smoothed_stereo_pairs(std::span<const StereoFrame> frames,
                                              const ParallaxBudget& budget,
                                              const SmoothingOptions& rates);

}  // namespace glassbox
