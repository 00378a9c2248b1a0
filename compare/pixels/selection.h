// The pixels that a comparison uses: all except those that a mask or a box leaves out.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// Pixels [x, x + width) x [y, y + height).
struct PixelBox {
  int x = 0, y = 0;
  int width = 0, height = 0;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

// The pixels that both boxes have; a width or a height that is not above 0 if there are none.
PixelBox intersection(const PixelBox& a, const PixelBox& b);

// Parses "x,y,wxh", with the origin at the top left: four whole numbers, the size above zero.
Result<PixelBox> parse_pixel_box(const std::string& text);
std::string to_string(const PixelBox& box);

class Selection {
public:
  // Selects all pixels.
  Selection(int width, int height);

  // Leaves out the pixels of the box. An error where the box is wholly outside the picture, because
  // that must be a mistake.
  Result<void> exclude(const PixelBox& box);
  // Leaves out a pixel of the picture.
  void exclude(int x, int y) { exclude(index(x, y)); }
  // Leaves out the pixels that are black in `mask`: every colour sample is 0 (alpha is ignored). An
  // error where its size is not the picture's.
  Result<void> exclude_black(const StoredImage& mask);

  bool includes_all() const { return excluded_.empty(); }
  bool compares(int x, int y) const { return excluded_.empty() || !excluded_[index(x, y)]; }
  std::uint64_t compared_pixels() const { return compared_; }

private:
  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }
  void exclude(std::size_t pixel);

  int width_, height_;
  std::uint64_t compared_;
  std::vector<bool> excluded_;  // empty: none
};

}  // namespace glassbox
