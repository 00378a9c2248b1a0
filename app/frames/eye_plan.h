// A pair of eyes for every frame, such that nothing either of them sees has more parallax than the budget.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/frames/shots.h"

#include <glassbox/pipeline/stereo/comfort.h>
#include <glassbox/render/renderer.h>

namespace glassbox::app {

struct EyeWishes {
  ParallaxBudget budget;
  std::optional<double> separation;  // the most; absent: a thirtieth of the farthest window
  double release_frames = 15;        // of the separation and of the window
  std::optional<double> max_step;    // of the separation; absent: its largest in release_frames
};

struct EyePlan {
  std::vector<StereoPair> pairs;
  double separation_bound = 0;  // the most that the eyes may be apart
  double step_bound = 0;  // the most that the separation may change in a frame; may be infinite
  std::vector<DepthSpan> spans;  // that the separations were chosen by
  std::vector<std::size_t>
      empty;         // frames in which nothing was seen: they count with their neighbours'
  int measured = 0;  // pairs of pictures drawn for it
  int widened = 0;   // of these, pairs that saw more than was known
};

// What both eyes of the pair see, in pictures of full size; none where nothing was drawn.
std::optional<DepthSpan> depth_seen_by(Renderer& renderer, const View& centre,
                                       const StereoPair& pair, const StereoSettings& settings);
std::optional<DepthSpan> depth_seen_in(const StereoRendering& pictures);

// First the separations for what a quick look of the camera between the eyes finds (depth_seen). It may miss what is thin,
// and what only the eyes see: so both eyes' distance planes are drawn for every frame, what they have beyond the known is
// added to it, and the separations that change for it are looked at again, until nothing is added.
//
// `look` is called before every look at a frame, with its index. An error names the frame.
Result<EyePlan> plan_eyes(Renderer& renderer, const std::vector<Shot>& shots,
                          const EyeWishes& wishes, const StereoSettings& settings,
                          const std::function<void(std::size_t)>& look);

}  // namespace glassbox::app
