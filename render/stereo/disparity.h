// Ground-truth disparity: how far apart the eyes see what each pixel shows.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/stereo/comfort.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// parallax_at of every pixel's distance, in px, right minus left: negative in front of the window, NaN where nothing
// was drawn. `distances` is a framebuffer's distance plane, of either eye or of the camera between them: the distance along
// the gaze, and so the disparity, is the same for all three. Off by the parallax of the distance's rounding to float.
Image<float> disparity_map(const View& centre, const StereoPair& pair,
                           const Image<float>& distances);

// Of the pixels that have a disparity.
struct DisparitySummary {
  std::uint64_t drawn = 0;
  double least_px = 0;     // what stands out most, or is least far behind; 0 where nothing is drawn
  double greatest_px = 0;  // the other end
  // Beyond the budget, in front of the window and behind it.
  std::uint64_t too_near = 0, too_far = 0;

  double share_beyond() const {
    return drawn == 0 ? 0 : double(too_near + too_far) / double(drawn);
  }
};
DisparitySummary summarise(const Image<float>& disparity, const ParallaxBudget& budget);

// Bin i holds the disparities from first_px + i bin_px up to, not including, the next bin's. The window is at the edge
// of a bin, so none has both what is in front and what is behind.
struct DisparityHistogram {
  double first_px = 0;
  double bin_px = 1;
  std::vector<std::uint64_t> counts;  // empty where nothing is drawn
};
// Bins 1, 2 or 5 times a power of ten wide, at least 0.001 px and a millionth of the largest disparity, the finest of
// which there are at most `most_bins` (>= 2).
DisparityHistogram histogram_of(const Image<float>& disparity, int most_bins = 64);

}  // namespace glassbox
