#include <glassbox/compare/report/page_crops.h>

#include <algorithm>

namespace glassbox {
namespace {

constexpr int kSurroundings = 64;  // px on each side of a region

struct Span {
  int start, length;
};

// The pixels of a region that are shown along one axis: the region with its surroundings, or, if
// these are too long, `side` pixels around `worst`.
Span shown(int start, int length, int worst, int size, int side) {
  int first = start - kSurroundings, last = start + length + kSurroundings;
  if (last - first > side) {
    first = worst - side / 2;
    last = first + side;
  }
  first = std::max(first, 0);
  return {first, std::min(last, size) - first};
}

bool shows(const std::vector<PixelBox>& crops, PixelPosition pixel) {
  return std::any_of(crops.begin(), crops.end(), [pixel](const PixelBox& crop) {
    return crop.x <= pixel.x && pixel.x < crop.x + crop.width && crop.y <= pixel.y &&
           pixel.y < crop.y + crop.height;
  });
}

}  // namespace

std::vector<PixelBox> crops_of(int width, int height, const Differences* differences,
                               const CropLimits& limits) {
  const auto pixels = std::uint64_t(width) * std::uint64_t(height);
  if (pixels <= limits.whole_pixels) return {{0, 0, width, height}};
  std::vector<PixelBox> crops;
  if (differences) {
    for (const Region& region : differences->regions) {
      if (crops.size() == limits.count) break;
      if (shows(crops, region.worst)) continue;
      const auto [x, columns] =
          shown(region.box.x, region.box.width, region.worst.x, width, limits.side);
      const auto [y, rows] =
          shown(region.box.y, region.box.height, region.worst.y, height, limits.side);
      crops.push_back({x, y, columns, rows});
    }
  }
  if (crops.empty())
    crops.push_back({0, 0, std::min(width, limits.side), std::min(height, limits.side)});
  return crops;
}

}  // namespace glassbox
