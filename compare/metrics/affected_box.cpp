#include <glassbox/compare/metrics/affected_box.h>

#include <algorithm>
#include <cstring>

namespace glassbox {
namespace {

PixelBox grown(const PixelBox& box, int by) {
  return {box.x - by, box.y - by, box.width + 2 * by, box.height + 2 * by};
}

// The pixels from the first to the last difference of the rows so far.
struct Extent {
  int left, right;  // px; [left, right)
  int top = 0, bottom = 0;
  bool empty() const { return bottom == 0; }
};

// The differences between the samples of two pictures.
template <class Sample>
class Differing {
public:
  Differing(const PicturePair& pair, const ChannelRange& channels)
      : reference_(std::get<std::vector<Sample>>(pair.reference.samples).data()),
        test_(std::get<std::vector<Sample>>(pair.test.samples).data()),
        channels_(channels),
        selection_(pair.selection),
        width_(std::size_t(pair.reference.width)),
        stride_(std::size_t(pair.reference.channels)) {}

  // Widens `extent` by the differences of row y of the area. Pixels between its sides are only
  // looked at to find whether the row has a difference.
  void add_row(const PixelBox& area, int y, Extent& extent) const {
    const std::size_t first = sample_of(area.x, y);
    if (std::memcmp(reference_ + first, test_ + first,
                    std::size_t(area.width) * stride_ * sizeof(Sample)) == 0)
      return;
    const int end = area.x + area.width;
    int left = area.x;
    while (left < end && !differs(left, y)) ++left;
    if (left == end) return;
    int right = end;
    while (right > extent.right && right > left + 1 && !differs(right - 1, y)) --right;
    if (extent.empty()) extent.top = y;
    extent.left = std::min(extent.left, left);
    extent.right = std::max(extent.right, right);
    extent.bottom = y + 1;
  }

private:
  std::size_t sample_of(int x, int y) const {
    return (std::size_t(y) * width_ + std::size_t(x)) * stride_;
  }
  bool differs(int x, int y) const {
    const std::size_t first = sample_of(x, y) + std::size_t(channels_.first);
    return !std::equal(reference_ + first, reference_ + first + channels_.count, test_ + first) &&
           selection_.compares(x, y);
  }

  const Sample* reference_;
  const Sample* test_;
  ChannelRange channels_;
  const Selection& selection_;
  std::size_t width_, stride_;
};

}  // namespace

PixelBox affected_box(const PicturePair& pair, const PixelBox& tile, int reach,
                      const ChannelRange& channels) {
  const PixelBox area =
      intersection(grown(tile, reach), {0, 0, pair.reference.width, pair.reference.height});
  Extent extent{area.x + area.width, area.x};
  std::visit(
      [&](const auto& samples) {
        using Sample = typename std::decay_t<decltype(samples)>::value_type;
        const Differing<Sample> differing(pair, channels);
        for (int y = area.y; y < area.y + area.height; ++y) differing.add_row(area, y, extent);
      },
      pair.reference.samples);
  if (extent.empty()) return {};
  const PixelBox around{extent.left, extent.top, extent.right - extent.left,
                        extent.bottom - extent.top};
  return intersection(tile, grown(around, reach));
}

std::uint64_t compared_pixels(const Selection& selection, const PixelBox& box) {
  if (selection.includes_all()) return std::uint64_t(box.width) * std::uint64_t(box.height);
  std::uint64_t compared = 0;
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) compared += selection.compares(x, y);
  }
  return compared;
}

}  // namespace glassbox
