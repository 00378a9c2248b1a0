// The ladder of the depth-format experiment (D-6): points on the axis at consecutive float
// distances (the rungs), whose codes should be in the same order; and the fragments for the timing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <glassbox/mesh/builtin/images.h>

#include "study/experiments/d06_formats.h"

namespace glassbox::study::d06 {

// Returns the float distances from z to z (1 + window), ascending, at most `count` of them.
inline std::vector<float> rungs(double z, double window, int count) {
  std::vector<float> all;
  for (int i = 0; i < count; ++i) {
    const auto distance = float(z * (1 + window * i / count));
    if (!all.empty() && distance == all.back()) continue;
    if (double(distance) > kFar) break;
    all.push_back(distance);
  }
  return all;
}

// The largest relative distance of two rungs (float distances) whose codes are equal or in the
// wrong order. The nearer rung is in the first quarter of the list, so that the list does not end
// before the farther one.
inline double largest_confusion(const std::vector<float>& rungs,
                                const std::vector<std::uint32_t>& codes) {
  std::vector<std::uint32_t> least(rungs.size());  // the least code from each rung on
  std::uint32_t running = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t i = rungs.size(); i-- > 0;) least[i] = running = std::min(running, codes[i]);
  double largest = 0;
  // The greatest code so far. A rung (a distance) whose code is not greater is nearer to all
  // farther rungs than the earlier rung with that code, so its confusions are not larger and it is
  // skipped.
  std::uint32_t greatest = 0;
  std::size_t j = 0;
  for (std::size_t i = 0; i < rungs.size() / 4 + 1; ++i) {
    if (i > 0 && codes[i] <= greatest) continue;
    greatest = codes[i];
    j = std::max(j, i);
    while (j + 1 < rungs.size() && least[j + 1] <= codes[i]) ++j;
    largest = std::max(largest, (double(rungs[j]) - double(rungs[i])) / double(rungs[i]));
  }
  return largest;
}

// Tests the distances in a window from z to z (1 + window). The window is doubled until it is 64
// times larger than the largest distance over which codes are confused. For windows of 2^-6 and
// more, 4 times is enough, because the steps of the format change within such a window. `codes_of`
// returns the codes of a list of distances.
template <class CodesOf>
double ladder_error(const CodesOf& codes_of, double z, int count) {
  for (double window = 0x1p-18;; window *= 2) {
    const std::vector<float> all = rungs(z, window, count);
    const double largest = largest_confusion(all, codes_of(all));
    const bool at_far = z * (1 + window) > kFar;
    if (at_far || largest * (window < 0x1p-6 ? 64 : 4) < window) {
      // If all codes are different and in order, the result is the distance of two neighbouring
      // floats: no format can do better.
      return std::max(largest, (double(all[1]) - double(all[0])) / z);
    }
  }
}

// ---- what is timed: the depth test of many fragments, each against a stored code ----

inline constexpr std::size_t kFragments = 1u << 17;

struct Fragments {
  std::vector<float> depth, w;
};

inline Fragments make_fragments(std::size_t count) {
  Fragments made;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = kNear * std::exp2(16 * random_unit(60, i));
    made.w.push_back(float(z));
    made.depth.push_back(float((1 / kNear - 1 / z) / (1 / kNear - 1 / kFar)));
  }
  return made;
}

}  // namespace glassbox::study::d06
