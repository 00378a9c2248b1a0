#include "views/layers/layered_image.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/LU>

namespace glassbox::views {

namespace {

// Whether a normal is unknown, or has the length 127 to within the rounding of its three
// components, which is at most 1/2 each.
bool is_legal(const SampleNormal& n) {
  const double length = std::sqrt(double(n.x * n.x + n.y * n.y + n.z * n.z));
  return !n.is_known() || std::abs(length - 127) <= std::sqrt(0.75);
}

}  // namespace

Result<void> check(const LayeredImage& image, const std::string& source) {
  const auto bad = [&](const std::string& what) {
    return fail(source, what, "build the layers again");
  };
  const LayerCamera& camera = image.camera;
  if (camera.width < 1 || camera.height < 1 || camera.width > kMaxImageSide ||
      camera.height > kMaxImageSide)
    return bad(fmt::format("has {} x {} pixels; 1 to {} in each direction are possible",
                           camera.width, camera.height, kMaxImageSide));
  const Eigen::Matrix4d& m = camera.screen_from_world;
  if (!m.allFinite() || !m.inverse().allFinite())
    return bad("has a camera whose matrix has no inverse");
  const std::size_t pixels = std::size_t(camera.width) * std::size_t(camera.height);
  if (image.first.size() != pixels + 1 || image.color.size() != image.depth.size())
    return bad(fmt::format("has {} offsets for {} pixels, {} colours for {} depths",
                           image.first.size(), pixels, image.color.size(), image.depth.size()));
  for (const std::size_t others : {image.normal.size(), image.triangle.size()}) {
    if (others != 0 && others != image.depth.size())
      return bad(
          fmt::format("has {} normals or triangles for {} samples", others, image.depth.size()));
  }
  if (image.first.front() != 0 || image.first.back() != image.depth.size())
    return bad(fmt::format(
        "has offsets from {} to {}, but they must go from 0 to {}, the number of samples",
        image.first.front(), image.first.back(), image.depth.size()));
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const std::string where = fmt::format("pixel {}, from the bottom left,", pixel);
    const std::uint32_t begin = image.first[pixel], end = image.first[pixel + 1];
    if (begin > end || end > image.depth.size())
      return bad(fmt::format(
          "{} has its samples from number {} to number {}, which is not a possible range", where,
          begin, end));
    for (std::size_t i = begin; i < end; ++i) {
      const float depth = image.depth[i];
      if (!std::isfinite(depth) || !(depth > 0))
        return bad(fmt::format("{} has the depth {}, but depths must be positive and finite", where,
                               depth));
      if (i > begin && !(image.depth[i - 1] < depth))
        return bad(fmt::format("{} has samples that are not in order from back to front", where));
      if (!image.normal.empty() && !is_legal(image.normal[i]))
        return bad(fmt::format("{} has a normal whose length is not 1", where));
    }
  }
  return {};
}

LayerCounts count_layers(const LayeredImage& image) {
  LayerCounts counts;
  counts.samples = image.samples();
  for (std::size_t pixel = 0; pixel + 1 < image.first.size(); ++pixel) {
    const std::size_t here = image.first[pixel + 1] - image.first[pixel];
    counts.covered += here > 0;
    counts.most = std::max(counts.most, here);
  }
  return counts;
}

}  // namespace glassbox::views
