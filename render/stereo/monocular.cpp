#include <glassbox/render/stereo/monocular.h>

#include <algorithm>
#include <cmath>

namespace glassbox {
namespace {

constexpr double kSame = 0.5;  // px; smaller differences count as equal

// Returns whether the other eye sees the point that this eye sees at pixel (x, y). `shift` is the
// direction from a pixel of this eye to the other eye's: 1 from left to right, -1 from right to
// left.
OtherEyeVisibility seen_by_other(const Image<float>& other, int x, int y, double disparity,
                                 int shift) {
  if (!std::isfinite(disparity)) return OtherEyeVisibility::kNothingDrawn;
  const double place = std::floor(x + 0.5 + shift * disparity);
  if (place < 0 || place >= other.width) return OtherEyeVisibility::kOutsidePicture;
  const int at = int(place);
  const double found = double(other.at(at, y));  // NaN (nothing drawn) is never nearer
  if (found < disparity - kSame) return OtherEyeVisibility::kHidden;
  for (int i = std::max(at - 1, 0); i <= std::min(at + 1, other.width - 1); ++i) {
    if (std::abs(double(other.at(i, y)) - disparity) <= kSame) return OtherEyeVisibility::kVisible;
  }
  return OtherEyeVisibility::kMissing;
}

Image<OtherEyeVisibility> map_of(const Image<float>& own, const Image<float>& other, int shift) {
  Image<OtherEyeVisibility> map(own.width, own.height);
  for (int y = 0; y < own.height; ++y) {
    for (int x = 0; x < own.width; ++x) {
      map.at(x, y) = seen_by_other(other, x, y, double(own.at(x, y)), shift);
    }
  }
  return map;
}

}  // namespace

MonocularMaps monocular_maps(const Image<float>& left_disparity,
                             const Image<float>& right_disparity) {
  return {map_of(left_disparity, right_disparity, 1), map_of(right_disparity, left_disparity, -1)};
}

MonocularCounts count_monocular(const Image<OtherEyeVisibility>& map) {
  MonocularCounts counts;
  for (const OtherEyeVisibility seen : map.pixels) {
    counts.beside += seen == OtherEyeVisibility::kOutsidePicture;
    counts.hidden += seen == OtherEyeVisibility::kHidden;
    counts.missing += seen == OtherEyeVisibility::kMissing;
  }
  return counts;
}

}  // namespace glassbox
