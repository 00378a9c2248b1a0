#include "views/features/window_descriptor.h"

#include <algorithm>
#include <cmath>

#include "views/features/scale_level.h"

namespace glassbox::views {

WindowDescriptor window_descriptor(const Image<float>& grey, double x, double y) {
  std::array<double, std::size_t(kPatchSide * kPatchSide)> values;
  std::size_t next = 0;
  double sum = 0;
  for (int dy = -kPatchRadius; dy <= kPatchRadius; ++dy) {
    for (int dx = -kPatchRadius; dx <= kPatchRadius; ++dx) {
      values[next] = grey_at(grey, x + dx, y + dy);
      sum += values[next++];
    }
  }
  const double mean = sum / double(values.size());
  double squares = 0;
  for (double& value : values) {
    value -= mean;
    squares += value * value;
  }
  const double length = std::sqrt(squares);
  WindowDescriptor window{};
  if (!(length > 0)) return window;
  for (std::size_t i = 0; i < values.size(); ++i) window[i] = float(values[i] / length);
  return window;
}

double distance(const WindowDescriptor& a, const WindowDescriptor& b) {
  // Four sums in place of one, because a processor can add to all of them at a time.
  constexpr std::size_t kSums = 4;
  std::array<double, kSums> sums{};
  std::size_t i = 0;
  for (; i + kSums <= a.size(); i += kSums) {
    for (std::size_t k = 0; k < kSums; ++k) sums[k] += double(a[i + k]) * double(b[i + k]);
  }
  double correlation = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  for (; i < a.size(); ++i) correlation += double(a[i]) * double(b[i]);
  return std::sqrt(std::max(0.0, 2 - 2 * correlation));
}

}  // namespace glassbox::views
