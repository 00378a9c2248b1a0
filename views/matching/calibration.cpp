#include "views/matching/calibration.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "views/matching/winner.h"

namespace glassbox::views {

namespace {

// Limits between which floats have full precision.
constexpr double kMinDepth = std::numeric_limits<float>::min(),
                 kMaxDepth = std::numeric_limits<float>::max();

}  // namespace

Result<void> check_calibration(const Calibration& calibration) {
  const double focal = calibration.focal_px, baseline = calibration.baseline,
               offset = calibration.offset_px;
  if (!(focal > 0 && std::isfinite(focal))) {
    return fail("--calibration", fmt::format("{:g} px is not a focal length", focal),
                "give F,B,OFFSET with F above 0");
  }
  if (!(baseline > 0 && std::isfinite(baseline))) {
    return fail("--calibration",
                fmt::format("{:g} is not a baseline: depth needs a baseline above 0", baseline),
                "give F,B,OFFSET with B above 0");
  }
  if (!std::isfinite(offset)) {
    return fail("--calibration", "the offset is not finite",
                "give F,B,OFFSET, with 0 for no offset");
  }
  // A parallax (disparity plus offset) is between 2^-24 px (the smallest fraction of a pixel) and
  // 2^15 px (the widest picture). The depth, focal * baseline divided by the parallax, must be a
  // float of full precision.
  constexpr double kLeast = 1e-30, kMost = 1e30;
  if (!(focal * baseline >= kLeast && focal * baseline <= kMost)) {
    return fail(
        "--calibration",
        fmt::format("depths for F B = {:g} do not fit into 32-bit floats", focal * baseline),
        "give the baseline in another unit");
  }
  return {};
}

Principal principal_of(const Calibration& calibration, int width, int height) {
  return calibration.principal.value_or(Principal{width / 2.0, height / 2.0});
}

Image<float> depths_of(const Image<float>& disparity, const Calibration& calibration) {
  Image<float> depths(disparity.width, disparity.height, kNoDisparity);
  const double product = calibration.focal_px * calibration.baseline;
  for (std::size_t i = 0; i < depths.pixels.size(); ++i) {
    const double parallax = double(disparity.pixels[i]) + calibration.offset_px;
    if (!std::isfinite(parallax) || parallax == 0) continue;
    const double depth = product / parallax;
    if (depth >= kMinDepth && depth <= kMaxDepth) depths.pixels[i] = float(depth);
  }
  return depths;
}

}  // namespace glassbox::views
