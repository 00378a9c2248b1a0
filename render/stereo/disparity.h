// Ground-truth disparity: the distance between the two eyes' images of the point that each pixel
// shows.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/stereo/parallax_budget.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// The disparity of every pixel: parallax_at() of its distance, in px, right minus left. Negative in
// front of the window, NaN where nothing was drawn. `distances` is a framebuffer's distance plane,
// of either eye or of the camera between them: the distance along the gaze, and so the disparity,
// is the same for all three. The error is the parallax that corresponds to the rounding of the
// distance to float.
Image<float> disparity_map(const View& centre, const StereoPair& pair,
                           const Image<float>& distances);

// A summary of the pixels that have a disparity.
struct DisparitySummary {
  std::uint64_t drawn = 0;
  double least_px = 0;     // nearest to the viewer; 0 where nothing is drawn
  double greatest_px = 0;  // farthest from the viewer
  // Pixels outside the budget, in front of the window and behind it.
  std::uint64_t too_near = 0, too_far = 0;

  double share_beyond() const {
    return drawn == 0 ? 0 : double(too_near + too_far) / double(drawn);
  }
};
DisparitySummary summarise_disparity(const Image<float>& disparity, const ParallaxBudget& budget);

// A histogram of disparities. Bin i contains those from first_px + i bin_px up to, but not
// including, the next bin's. The window is at the edge of a bin, so no bin contains both
// disparities in front of it and behind it.
struct DisparityHistogram {
  double first_px = 0;
  double bin_px = 1;
  std::vector<std::uint64_t> counts;  // empty where nothing is drawn
};
// The width of the bins is 1, 2 or 5 times a power of ten, at least 0.001 px and at least a
// millionth of the largest disparity. It is the smallest width that gives at most `most_bins` (>=
// 2) bins.
DisparityHistogram histogram_of(const Image<float>& disparity, int most_bins = 64);

}  // namespace glassbox
