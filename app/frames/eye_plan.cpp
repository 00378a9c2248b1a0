#include "app/frames/eye_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <glassbox/pipeline/stereo/parallax_budget.h>
#include <glassbox/render/visible_depth_span.h>

namespace glassbox::app {

namespace {

// The planner draws the frames in rounds, until no frame shows depths outside the range known for
// it. From this round on, a frame that still does so gets the whole range of depths, so that
// planning ends.
constexpr int kRoundsBeforeWholeRange = 8;

RenderSettings distance_only(RenderSettings settings) {
  settings.samples = 1;
  settings.shading = Shading::kUnlit;
  settings.show = Show::kColor;
  settings.want_distance = true;
  settings.want_id = false;
  return settings;
}

bool contains_span(const DepthSpan& known, const DepthSpan& seen) {
  return known.nearest <= seen.nearest && seen.farthest <= known.farthest;
}

DepthSpan union_of(const DepthSpan& a, const DepthSpan& b) {
  return {std::min(a.nearest, b.nearest), std::max(a.farthest, b.farthest)};
}

// The range of distances that can be drawn at all, from the near to the far plane. The margin
// covers the few rounding errors of the distances, which are floats (render/engine/distance.h).
DepthSpan whole_range(const View& view) {
  constexpr double kMargin = 1e-6;
  const double far = std::isinf(view.far) ? 0 : std::abs(view.far);
  const double margin =
      kMargin * (view.perspective ? view.near : std::max(std::abs(view.near), far));
  return {view.near - margin, view.far + kMargin * far};
}

// A frame in which nothing is seen has no span of depths: it gets the span of the frame before it.
// Such frames at the beginning get the first known span.
void fill_gaps(std::vector<StereoFrame>& frames, const std::vector<std::size_t>& empty) {
  std::vector<bool> known(frames.size(), true);
  for (const std::size_t i : empty) known[i] = false;
  const auto first = std::size_t(std::ranges::find(known, true) - known.begin());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (known[i]) continue;
    if (first == frames.size()) {
      frames[i].span = whole_range(frames[i].centre);
    } else {
      frames[i].span = frames[i < first ? first : i - 1].span;
    }
  }
}

class Planner {
public:
  Planner(Renderer& renderer, const std::vector<SequenceFrame>& sequence,
          const EyePlanLimits& limits, const StereoSettings& settings,
          const std::function<void(std::size_t)>& look)
      : renderer_(renderer),
        sequence_(sequence),
        limits_(limits),
        settings_(settings),
        look_(look) {}

  Result<EyePlan> plan() {
    find_first_spans();
    set_bounds();
    plan_.pairs = smoothed_stereo_pairs(frames_, limits_.budget, rates_);
    std::vector<std::size_t> unproven(frames_.size());
    for (std::size_t i = 0; i < unproven.size(); ++i) unproven[i] = i;
    for (int round = 0; !unproven.empty(); ++round) {
      if (const auto legal = check_pairs(unproven); !legal) return tl::unexpected(legal.error());
      bool grown = false;
      for (const std::size_t i : unproven) {
        look_(i);
        if (widen_span(i, round)) grown = true;
      }
      if (!grown) break;
      unproven = replan();
    }
    for (const StereoFrame& frame : frames_) plan_.spans.push_back(frame.span);
    return plan_;
  }

private:
  void find_first_spans() {
    for (std::size_t i = 0; i < sequence_.size(); ++i) {
      look_(i);
      const auto seen = visible_depth_span(renderer_, sequence_[i].centre, settings_.render);
      if (!seen) plan_.empty_frames.push_back(i);
      frames_.push_back({sequence_[i].centre, seen.value_or(DepthSpan{}), sequence_[i].window});
    }
    fill_gaps(frames_, plan_.empty_frames);
  }

  void set_bounds() {
    double farthest_window = 0;
    for (const SequenceFrame& frame : sequence_)
      farthest_window = std::max(farthest_window, frame.window);
    plan_.separation_bound = limits_.separation.value_or(farthest_window / kWindowsPerSeparation);
    rates_.at_most = plan_.separation_bound / 2;
    rates_.window_frames = rates_.release_frames = limits_.release_frames;
    plan_.step_bound = limits_.max_step.value_or(largest_limit() / limits_.release_frames);
    // If all separations are 0, the bound would be 0 or NaN. Then there is no bound on the change
    // per frame, and none either if release_frames is 0, because the quotient is then infinite.
    if (!(plan_.step_bound > 0)) plan_.step_bound = std::numeric_limits<double>::infinity();
    rates_.max_step = plan_.step_bound / 2;
  }

  // The largest separation that the parallax budget allows in any frame.
  double largest_limit() const {
    SmoothingOptions free = rates_;
    free.release_frames = 0;
    double largest = 0;
    for (const StereoPair& pair : smoothed_stereo_pairs(frames_, limits_.budget, free)) {
      largest = std::max(largest, 2 * pair.half_separation);
    }
    return largest;
  }

  Result<void> check_pairs(const std::vector<std::size_t>& which) const {
    for (const std::size_t i : which) {
      const auto legal = check_pair(frames_[i].centre, plan_.pairs[i]);
      if (legal) continue;
      const Error& error = legal.error();
      return fail(fmt::format("frame {}", sequence_[i].number), error.place + ": " + error.cause,
                  error.remedy);
    }
    return {};
  }

  // Draws both eyes' pictures of a frame and adds the depths seen to its span. Returns whether the
  // span grew.
  bool widen_span(std::size_t i, int round) {
    ++plan_.measured_pairs;
    const auto seen = depth_seen_by(renderer_, frames_[i].centre, plan_.pairs[i], settings_);
    if (!seen || contains_span(frames_[i].span, *seen)) return false;
    ++plan_.widening_pairs;
    frames_[i].span = union_of(frames_[i].span, *seen);
    if (round >= kRoundsBeforeWholeRange) {
      frames_[i].span = union_of(frames_[i].span, whole_range(frames_[i].centre));
    }
    return true;
  }

  // Chooses the separations of all frames again. Returns the frames whose separation has changed.
  std::vector<std::size_t> replan() {
    std::vector<StereoPair> pairs = smoothed_stereo_pairs(frames_, limits_.budget, rates_);
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (pairs[i].half_separation != plan_.pairs[i].half_separation) changed.push_back(i);
    }
    plan_.pairs = std::move(pairs);
    return changed;
  }

  Renderer& renderer_;
  const std::vector<SequenceFrame>& sequence_;
  const EyePlanLimits& limits_;
  const StereoSettings& settings_;
  const std::function<void(std::size_t)>& look_;
  std::vector<StereoFrame> frames_;
  SmoothingOptions rates_;
  EyePlan plan_;
};

}  // namespace

std::optional<DepthSpan> depth_seen_in(const StereoRendering& pictures) {
  const auto left = depth_span(pictures.left.distance);
  const auto right = depth_span(pictures.right.distance);
  if (left && right) return union_of(*left, *right);
  return left ? left : right;
}

std::optional<DepthSpan> depth_seen_by(Renderer& renderer, const View& centre,
                                       const StereoPair& pair, const StereoSettings& settings) {
  const StereoSettings probe{distance_only(settings.render), settings.culling};
  return depth_seen_in(renderer.render_pair(centre, pair, probe));
}

Result<EyePlan> plan_eyes(Renderer& renderer, const std::vector<SequenceFrame>& sequence,
                          const EyePlanLimits& limits, const StereoSettings& settings,
                          const std::function<void(std::size_t)>& look) {
  return Planner(renderer, sequence, limits, settings, look).plan();
}

}  // namespace glassbox::app
