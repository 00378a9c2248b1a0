#include <glassbox/images/stereo/layouts.h>

#include <algorithm>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include <glassbox/images/out_of_memory.h>

namespace glassbox {
namespace {

constexpr NamedChoice<StereoLayout> kLayouts[] = {
    {StereoLayout::kPair, "pair", "side by side at full size, left eye on the left"},
    {StereoLayout::kOverUnder, "over-under", "one above the other at full size, left eye above"},
    {StereoLayout::kCrossEyed, "cross-eyed", "side by side at full size, right eye on the left"},
    {StereoLayout::kInterlaced, "interlaced", "row by row; the left eye has the even rows"},
};

void copy_row(const Image<Rgba8>& from, int from_y, Image<Rgba8>& to, int to_x, int to_y) {
  const auto row = from.pixels.begin() + std::ptrdiff_t(from.index(0, from_y));
  std::copy(row, row + from.width, to.pixels.begin() + std::ptrdiff_t(to.index(to_x, to_y)));
}

Image<Rgba8> side_by_side(const Image<Rgba8>& first, const Image<Rgba8>& second) {
  Image<Rgba8> both(2 * first.width, first.height);
  for (int y = 0; y < first.height; ++y) {
    copy_row(first, y, both, 0, y);
    copy_row(second, y, both, first.width, y);
  }
  return both;
}

Image<Rgba8> one_over_the_other(const Image<Rgba8>& above, const Image<Rgba8>& below) {
  Image<Rgba8> both(above.width, 2 * above.height);
  for (int y = 0; y < above.height; ++y) {
    copy_row(above, y, both, 0, y);
    copy_row(below, y, both, 0, above.height + y);
  }
  return both;
}

Image<Rgba8> row_by_row(const Image<Rgba8>& even, const Image<Rgba8>& odd) {
  Image<Rgba8> both = even;
  for (int y = 1; y < both.height; y += 2) copy_row(odd, y, both, 0, y);
  return both;
}

}  // namespace

std::span<const NamedChoice<StereoLayout>> all_stereo_layouts() {
  return kLayouts;
}

std::string_view name_of(StereoLayout layout) {
  return kLayouts[std::size_t(layout)].name;
}

Result<Image<Rgba8>> make_stereo_layout(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                        StereoLayout layout) {
  const Result<void> same_size = check_eyes(std::string(name_of(layout)), left, right);
  if (!same_size) return tl::unexpected(same_size.error());
  constexpr int kLargest = std::numeric_limits<int>::max() / 2;
  if (layout != StereoLayout::kInterlaced && std::max(left.width, left.height) > kLargest) {
    return fail(std::string(name_of(layout)),
                fmt::format("two pictures of {}x{} pixels are too large for one picture",
                            left.width, left.height),
                "make both pictures smaller");
  }
  return unless_out_of_memory([&]() -> Result<Image<Rgba8>> {
    switch (layout) {
      case StereoLayout::kOverUnder:
        return one_over_the_other(left, right);
      case StereoLayout::kCrossEyed:
        return side_by_side(right, left);
      case StereoLayout::kInterlaced:
        return row_by_row(left, right);
      case StereoLayout::kPair:
        break;
    }
    return side_by_side(left, right);
  });
}

}  // namespace glassbox
