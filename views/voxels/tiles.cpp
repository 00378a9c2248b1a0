#include "views/voxels/tiles.h"

#include <algorithm>
#include <cmath>

namespace glassbox::views {

namespace {

constexpr int kTile = 4, kTileShift = 2;  // px
constexpr std::uint32_t kOneBit = 63;

// Calls each(word, mask) for the bits first .. last of a row of tiles, until it returns false:
// `word` is the index of a word of 64 bits, `mask` has its bits that are in the range.
template <class Each>
bool all_words(std::int64_t first, std::int64_t last, const Each& each) {
  for (std::int64_t word = first / 64; word <= last / 64; ++word) {
    std::uint64_t mask = ~std::uint64_t(0);
    if (word == first / 64) mask &= ~std::uint64_t(0) << (first % 64);
    if (word == last / 64) mask &= ~std::uint64_t(0) >> (63 - last % 64);
    if (!each(std::size_t(word), mask)) return false;
  }
  return true;
}

}  // namespace

PixelTiles::PixelTiles(const PackedPicture& picture)
    : width_((picture.width + kTile - 1) / kTile),
      height_((picture.height + kTile - 1) / kTile),
      words_((width_ + 63) / 64),
      pixels_wide_(picture.width),
      pixels_high_(picture.height),
      shows_whole_object_(picture.shows_whole_object),
      left_(std::size_t(width_) * std::size_t(height_), 0),
      background_(std::size_t(words_) * std::size_t(height_), 0),
      hidden_(background_) {
  std::vector<std::uint8_t> objects(left_.size(), 0);
  for (int y = 0; y < picture.height; ++y) {
    const std::uint32_t* words = picture.words.data() + std::size_t(y) * std::size_t(picture.width);
    const std::size_t row = std::size_t(y >> kTileShift) * std::size_t(width_);
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t tile = row + std::size_t(x >> kTileShift);
      const bool is_background = (words[x] & kBackground) != 0;
      objects[tile] = std::uint8_t(objects[tile] + !is_background);
      left_[tile] = std::uint8_t(left_[tile] + (is_background || (words[x] & kHidden) == 0));
    }
  }
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const std::size_t tile = std::size_t(y) * std::size_t(width_) + std::size_t(x);
      const std::size_t word = std::size_t(y) * std::size_t(words_) + std::size_t(x / 64);
      const std::uint64_t bit = std::uint64_t(1) << (std::uint32_t(x) & kOneBit);
      if (objects[tile] == 0) background_[word] |= bit;
      if (left_[tile] == 0) hidden_[word] |= bit;
    }
  }
}

double PixelTiles::bytes_for(int width, int height) {
  const double across = std::ceil(double(width) / kTile), down = std::ceil(double(height) / kTile);
  return down * (across + 2 * 8 * std::ceil(across / 64));
}

void PixelTiles::hide(int column, int row) {
  const int x = column >> kTileShift, y = row >> kTileShift;
  if (--left_[std::size_t(y) * std::size_t(width_) + std::size_t(x)] != 0) return;
  hidden_[std::size_t(y) * std::size_t(words_) + std::size_t(x / 64)] |=
      std::uint64_t(1) << (std::uint32_t(x) & kOneBit);
}

bool PixelTiles::is_partly_outside(const PixelRect& rect) const {
  return rect.left < 0 || rect.top < 0 || rect.right >= pixels_wide_ || rect.bottom >= pixels_high_;
}

PixelRect PixelTiles::clipped_to_picture(const PixelRect& rect) const {
  return {std::max<std::int64_t>(rect.left, 0), std::max<std::int64_t>(rect.top, 0),
          std::min<std::int64_t>(rect.right, pixels_wide_ - 1),
          std::min<std::int64_t>(rect.bottom, pixels_high_ - 1)};
}

// Whether the bits of all tiles in the rectangle are set; also true if there are no pixels.
bool PixelTiles::has_all(const std::vector<std::uint64_t>& bits, const PixelRect& inside) const {
  if (inside.left > inside.right) return true;
  for (std::int64_t y = inside.top >> kTileShift; y <= inside.bottom >> kTileShift; ++y) {
    const std::uint64_t* row = bits.data() + std::size_t(y) * std::size_t(words_);
    const bool all =
        all_words(inside.left >> kTileShift, inside.right >> kTileShift,
                  [&](std::size_t word, std::uint64_t mask) { return (row[word] & mask) == mask; });
    if (!all) return false;
  }
  return true;
}

bool PixelTiles::is_background(const PixelRect& rect) const {
  if (!shows_whole_object_ && is_partly_outside(rect)) return false;
  return has_all(background_, clipped_to_picture(rect));
}

bool PixelTiles::is_hidden(const PixelRect& rect) const {
  if (shows_whole_object_ && is_partly_outside(rect)) return false;
  return has_all(hidden_, clipped_to_picture(rect));
}

std::optional<PixelRect> rect_of(const GridPicture& lens, const VoxelBox& box) {
  const ProjectionMatrix& m = lens.pixel_from_grid;
  const Vector3d low(box.low.x + 0.5, box.low.y + 0.5, box.low.z + 0.5),
      high(box.high.x + 0.5, box.high.y + 0.5, box.high.z + 0.5);
  // A position in float has three roundings (of the start, the product and the sum), each by at
  // most 2^-24 times the magnitude that `reach` computes. A fourth 2^-24 covers the products of
  // these errors.
  constexpr double kRounding = 4 * 0x1p-24;
  const Vector3d reach = kRounding * (m.leftCols<3>().cwiseAbs() * high + m.col(3).cwiseAbs());
  double nearest = INFINITY, left = INFINITY, right = -INFINITY, top = INFINITY, bottom = -INFINITY;
  const Vector3d start = m.leftCols<3>() * low + m.col(3), way = high - low;
  for (int corner = 0; corner < 8; ++corner) {
    Vector3d h = start;
    bool is_new = true;
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) == 0) continue;
      is_new = is_new && way[axis] != 0;
      h += way[axis] * m.col(axis);
    }
    if (!is_new) continue;
    nearest = std::min(nearest, h.z());
    const double u = h.x() / h.z(), v = h.y() / h.z();
    left = std::min(left, u);
    right = std::max(right, u);
    top = std::min(top, v);
    bottom = std::max(bottom, v);
  }
  // The rectangle is enlarged by one pixel on each side. Half a pixel is for the rounding in float,
  // the other half for the computation in double here.
  constexpr double kMaxOff = 0.5;
  const double least = nearest - reach.z();
  const double farthest =
      std::max({std::abs(left), std::abs(right), std::abs(top), std::abs(bottom)});
  const double off =
      (std::max(reach.x(), reach.y()) + farthest * reach.z()) / least + kRounding * farthest;
  if (!(least > 0) || !(off <= kMaxOff)) return std::nullopt;
  return PixelRect{std::int64_t(std::floor(left)) - 1, std::int64_t(std::floor(top)) - 1,
                   std::int64_t(std::floor(right)) + 1, std::int64_t(std::floor(bottom)) + 1};
}

}  // namespace glassbox::views
