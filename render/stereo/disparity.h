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

// Returns the disparity of every pixel: the x of its point in the right eye's picture minus that in
// the left eye's, in px, computed from its distance (parallax_at). It is negative in front of the
// window, and NaN where nothing was drawn. `distances` is the distance image of a framebuffer, of
// either eye or of the camera between them: the distance along the gaze, and so the disparity, is
// the same for all three. The error of a disparity comes from the rounding of the distance to
// float.
Image<float> disparity_map(const View& centre, const StereoPair& pair,
                           const Image<float>& distances);

// A summary of the disparities of a picture's pixels, without those where nothing was drawn.
struct DisparitySummary {
  std::uint64_t drawn = 0;
  double least_px = 0;     // of the point nearest to the viewer; 0 where nothing is drawn
  double greatest_px = 0;  // of the point farthest from the viewer
  // The numbers of pixels that exceed the budget, in front of the window and behind it.
  std::uint64_t too_near = 0, too_far = 0;

  double share_beyond() const {
    return drawn == 0 ? 0 : double(too_near + too_far) / double(drawn);
  }
};
DisparitySummary summarise_disparity(const Image<float>& disparity, const ParallaxBudget& budget);

// A histogram of disparities. Bin i contains the disparities from first_px + i bin_px up to, but
// not including, first_px + (i + 1) bin_px. The window is at the edge of a bin, so no bin contains
// both disparities in front of it and behind it.
struct DisparityHistogram {
  double first_px = 0;
  double bin_px = 1;
  std::vector<std::uint64_t> counts;  // empty where nothing is drawn
};
// Makes a histogram. The width of its bins is 1, 2 or 5 times a power of ten, at least 0.001 px and
// at least a millionth of the largest disparity. It is the smallest width that gives at most
// `most_bins` (>= 2) bins.
DisparityHistogram histogram_of(const Image<float>& disparity, int most_bins = 64);

}  // namespace glassbox
