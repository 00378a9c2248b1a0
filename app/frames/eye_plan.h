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
  std::optional<double> separation;  // the upper bound; absent: a thirtieth of the farthest window
  double release_frames = 15;        // for the separation and for the window
  // of the separation per frame; absent: the largest separation / release_frames
  std::optional<double> max_step;
};

struct EyePlan {
  std::vector<StereoPair> pairs;
  double separation_bound = 0;   // the largest separation allowed
  double step_bound = 0;         // the largest change of the separation per frame; may be infinite
  std::vector<DepthSpan> spans;  // the depths for which the separations were chosen
  // frames in which nothing was seen: they use the span of a neighbouring frame
  std::vector<std::size_t> empty_frames;
  int measured_pairs = 0;  // pairs of pictures drawn for the plan
  int widening_pairs = 0;  // of these, pairs that showed depths outside the span known before
};

// The depths that both eyes of the pair see, in pictures of full size; none if nothing was drawn.
std::optional<DepthSpan> depth_seen_by(Renderer& renderer, const View& centre,
                                       const StereoPair& pair, const StereoSettings& settings);
std::optional<DepthSpan> depth_seen_in(const StereoRendering& pictures);

// Chooses the separations for every frame.
//
// The first separations fit the depths that a quick look from the camera between the eyes finds
// (visible_depth_span). It may miss thin things, and things that only the eyes see. So both eyes'
// distance planes are drawn for every frame, and depths outside the known span are added to it. The
// frames whose separations change because of this are drawn again, until nothing is added.
//
// `look` is called before every look at a frame, with its index. An error names the frame.
Result<EyePlan> plan_eyes(Renderer& renderer, const std::vector<SequenceFrame>& sequence,
                          const EyePlanLimits& limits, const StereoSettings& settings,
                          const std::function<void(std::size_t)>& look);

}  // namespace glassbox::app
