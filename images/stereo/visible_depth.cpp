#include <glassbox/images/stereo/visible_depth.h>

#include <cmath>

#include <fmt/format.h>

#include <glassbox/images/stereo/check_eyes.h>

namespace glassbox {
namespace {

// The luma in thousandths of a byte: exact.
int luma_of(const Rgba8& pixel) {
  return 299 * pixel.r + 587 * pixel.g + 114 * pixel.b;
}

}  // namespace

Result<Image<std::uint8_t>> information_map(const Image<Rgba8>& left, const Image<float>& disparity,
                                            const InformationLimits& limits) {
  if (const auto checked = check_disparity(left, disparity); !checked) {
    return tl::unexpected(checked.error());
  }
  if (!(limits.gradient >= 0) || !(limits.disparity >= 0)) {
    return fail("stereo information",
                fmt::format("the limit of the gradient is {} and that of the disparity is {}, but "
                            "both must be at least 0",
                            limits.gradient, limits.disparity),
                "give the gradient in bytes per pixel and the disparity in pixels");
  }
  Image<std::uint8_t> marks(left.width, left.height, 0);
  for (int y = 0; y < left.height; ++y) {
    for (int x = 1; x + 1 < left.width; ++x) {
      const double shift = double(disparity.at(x, y));
      if (!std::isfinite(shift)) continue;
      const int rise = luma_of(left.at(x + 1, y)) - luma_of(left.at(x - 1, y));
      const bool is_edge = std::abs(rise) > 2000 * limits.gradient;
      const bool is_displaced = std::abs(shift) > limits.disparity;
      marks.at(x, y) = std::uint8_t(kMarkCounted | (is_edge ? kMarkEdge : 0) |
                                    (is_displaced ? kMarkDisplaced : 0));
    }
  }
  return marks;
}

Result<StereoInformation> stereo_information(const Image<Rgba8>& left,
                                             const Image<float>& disparity,
                                             const InformationLimits& limits) {
  return information_map(left, disparity, limits).map([](const Image<std::uint8_t>& marks) {
    StereoInformation found;
    for (const std::uint8_t mark : marks.pixels) {
      const bool is_edge = (mark & kMarkEdge) != 0, is_displaced = (mark & kMarkDisplaced) != 0;
      found.pixels += (mark & kMarkCounted) != 0;
      found.edges += is_edge;
      found.displaced += is_displaced;
      found.score += is_edge && is_displaced;
    }
    if (!marks.pixels.empty()) found.share = double(found.score) / double(marks.pixels.size());
    return found;
  });
}

}  // namespace glassbox
