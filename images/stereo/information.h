// How much depth a picture gives to see (S0-16).
#pragma once

#include <cstdint>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox {

// Where an edge counts, and where a disparity does.
struct InformationLimits {
  double gradient = 4;     // bytes a pixel: of 255 for white
  double disparity = 0.5;  // px: less is within the sampling
};

// What a pixel counts as, as bits.
enum InformationMark : std::uint8_t {
  kMarkCounted = 1,  // has both neighbours in its row and a disparity
  kMarkEdge = 2,
  kMarkDisplaced = 4,
};

struct StereoInformation {
  std::uint64_t pixels = 0;     // that have both neighbours in their row and a disparity
  std::uint64_t edges = 0;      // of those, where the gradient is above the limit
  std::uint64_t displaced = 0;  // of those, where the disparity is
  std::uint64_t score = 0;  // of those, where both are: edges that the eyes see at different places
  double share = 0;         // score / all pixels of the picture
};

// The gradient is half the difference of the luma (ITU-R BT.601, of the bytes as stored) of a pixel's left and right
// neighbours; the disparity is ground truth in px, right minus left, and NaN or infinite where nothing was drawn.
// Disparity that is the same all over counts too: it is away from the window. Refuses sizes that differ and limits that
// are negative or no number.
Result<StereoInformation> stereo_information(const Image<Rgba8>& left,
                                             const Image<float>& disparity,
                                             const InformationLimits& limits = {});

// The InformationMark of every pixel, which is what stereo_information counts.
Result<Image<std::uint8_t>> information_map(const Image<Rgba8>& left, const Image<float>& disparity,
                                            const InformationLimits& limits = {});

}  // namespace glassbox
