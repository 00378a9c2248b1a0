// Measures how much visible depth a picture has (S0-16).
#pragma once

#include <cstdint>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox {

// The thresholds above which a gradient counts as an edge, and a disparity as displacement.
struct InformationLimits {
  double gradient = 4;     // bytes a pixel; white is 255
  double disparity = 0.5;  // px: a smaller disparity is within the sampling error
};

// What is known about a pixel, as bits.
enum InformationMark : std::uint8_t {
  kMarkCounted = 1,  // has both neighbours in its row and a disparity
  kMarkEdge = 2,
  kMarkDisplaced = 4,
};

struct StereoInformation {
  std::uint64_t pixels = 0;     // pixels that have both neighbours in their row and a disparity
  std::uint64_t edges = 0;      // how many of `pixels` have a gradient above the limit
  std::uint64_t displaced = 0;  // how many of `pixels` have a disparity above the limit
  // How many of `pixels` are edges and displaced: edges that the eyes see at different places.
  std::uint64_t score = 0;
  double share = 0;  // score / all pixels of the picture
};

// The gradient of a pixel is half the difference of the luma of its left and right neighbours
// (ITU-R BT.601, of the bytes as stored). The disparity is ground truth in px, right minus left,
// and NaN or infinite where nothing was drawn. A disparity that is the same everywhere counts, too:
// the scene is then in front of or behind the stereo window. Refuses sizes that differ and limits
// that are negative or NaN.
Result<StereoInformation> stereo_information(const Image<Rgba8>& left,
                                             const Image<float>& disparity,
                                             const InformationLimits& limits = {});

// The InformationMark of every pixel; stereo_information counts these marks.
Result<Image<std::uint8_t>> information_map(const Image<Rgba8>& left, const Image<float>& disparity,
                                            const InformationLimits& limits = {});

}  // namespace glassbox
