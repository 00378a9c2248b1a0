// Chooses a pair of eyes for every frame, such that nothing visible to either has more parallax
// than the budget.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "cli/frames/sequence_frames.h"

#include <glassbox/pipeline/stereo/parallax_budget.h>
#include <glassbox/render/renderer.h>

namespace glassbox::app {

struct EyePlanLimits {
  ParallaxBudget budget;
  std::optional<double> separation;  // upper bound; absent: 1/30 of the farthest window's distance
  double release_frames = 15;        // over how many frames separation and window are smoothed
  // the largest change of the separation per frame; absent: the largest separation / release_frames
  std::optional<double> max_step;
};

struct EyePlan {
  std::vector<StereoPair> pairs;
  double separation_bound = 0;   // the largest separation allowed
  double step_bound = 0;         // the largest change of the separation per frame; may be infinite
  std::vector<DepthSpan> spans;  // the depths for which the separations were chosen
  // frames in which nothing was seen: they use the span of a neighbouring frame
  std::vector<std::size_t> empty_frames;
  int measured_pairs = 0;  // how many pairs of pictures were drawn for the plan
  int widening_pairs = 0;  // how many pairs showed depths outside the span known before
};

// The span of all depths that the left or the right eye sees, in pictures of full size; none if
// nothing was drawn.
std::optional<DepthSpan> depth_seen_by(Renderer& renderer, const View& centre,
                                       const StereoPair& pair, const StereoSettings& settings);
std::optional<DepthSpan> depth_seen_in(const StereoRendering& pictures);

// Chooses the separation of the eyes for every frame.
//
// The first separations fit the depths that are found by a quick look from the camera between the
// eyes (visible_depth_span). It may miss thin things, and things that only one of the eyes sees. So
// the distance at every pixel is then drawn for both eyes in every frame, and depths outside the
// known span are added to it. The frames whose separations change because of this are drawn again,
// until nothing is added.
//
// `look` is called with the index of each frame whenever the frame is about to be examined. An
// error names the frame.
Result<EyePlan> plan_eyes(Renderer& renderer, const std::vector<SequenceFrame>& sequence,
                          const EyePlanLimits& limits, const StereoSettings& settings,
                          const std::function<void(std::size_t)>& look);

}  // namespace glassbox::app
