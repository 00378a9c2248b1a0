// Where two pictures differ and by how much, exactly, in steps of their format: 1/255, 1/65535, or ulps of a float.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glassbox/compare/pixels/selection.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// Further apart than any count of steps: NaN and a number, an infinity and anything else.
inline constexpr std::uint32_t kUnbounded = std::numeric_limits<std::uint32_t>::max();

// Two pictures of the same size, channels and format, and what is compared of them.
struct PicturePair {
  const StoredImage& reference;
  const StoredImage& test;
  const Selection& selection;
  bool nan_equals_nan = false;
};

// The number of floats from a to b: 0 for the same bits, 1 for neighbours, of which -0 and +0 are a pair, too. NaN is
// kUnbounded away from everything, from NaN too unless `nan_equals_nan`; so is an infinity from everything else.
std::uint32_t ulp_distance(float a, float b, bool nan_equals_nan);

// The largest difference of a channel in each pixel of row y, in steps; 0 where the selection leaves the pixel out.
// `steps` has one place a pixel. False if no step can be above 0, which is known sooner than the steps.
bool row_differences(const PicturePair& pair, int y, std::span<std::uint32_t> steps);

struct PixelAt {
  int x = 0, y = 0;
  friend bool operator==(const PixelAt&, const PixelAt&) = default;
};

// Pixels that differ and touch each other, corners included.
struct Region {
  PixelBox box;
  std::uint64_t pixels = 0;
  std::uint32_t largest = 0;  // steps
  PixelAt worst;              // the first pixel, row by row, that differs by `largest`
};

struct Differences {
  std::uint64_t compared = 0;   // pixels
  std::uint64_t differing = 0;  // pixels
  std::uint32_t largest = 0;    // steps
  PixelAt first;                // row by row, where differing > 0
  PixelBox box;                 // of all pixels that differ
  std::uint64_t region_count = 0;
  // The worst first: by largest difference, then by pixels; `kept_regions` at most.
  std::vector<Region> regions;
};

// One pass over the rows; memory in proportion to a row and to the regions kept.
Differences find_differences(const PicturePair& pair, std::size_t kept_regions = 100);

}  // namespace glassbox
