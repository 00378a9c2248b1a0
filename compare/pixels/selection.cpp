#include <glassbox/compare/pixels/selection.h>

#include <algorithm>
#include <charconv>

#include <glassbox/base/printable.h>
#include <glassbox/compare/pixels/alpha.h>

namespace glassbox {
namespace {

// Reads a whole number at the front of `text` and removes it.
bool take_number(std::string_view& text, int& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return false;
  text.remove_prefix(std::size_t(end - text.data()));
  return true;
}

bool take(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

bool is_black(const StoredImage& mask, std::size_t pixel) {
  const auto colours = std::size_t(mask.channels - (has_alpha(mask.channels) ? 1 : 0));
  return std::visit(
      [&](const auto& samples) {
        const auto first = samples.begin() + std::ptrdiff_t(pixel * std::size_t(mask.channels));
        return std::all_of(first, first + std::ptrdiff_t(colours),
                           [](auto sample) { return sample == 0; });
      },
      mask.samples);
}

}  // namespace

PixelBox intersection(const PixelBox& a, const PixelBox& b) {
  const int left = std::max(a.x, b.x), top = std::max(a.y, b.y);
  return {left, top, std::min(a.x + a.width, b.x + b.width) - left,
          std::min(a.y + a.height, b.y + b.height) - top};
}

Result<PixelBox> parse_pixel_box(const std::string& text) {
  std::string_view rest = text;
  PixelBox box;
  const bool good = take_number(rest, box.x) && take(rest, ',') && take_number(rest, box.y) &&
                    take(rest, ',') && take_number(rest, box.width) && take(rest, 'x') &&
                    take_number(rest, box.height) && rest.empty();
  if (!good || box.width <= 0 || box.height <= 0) {
    return fail("", "not a box of pixels: " + in_quotes(text),
                "write x,y,widthxheight in whole numbers, as in 10,20,64x32");
  }
  return box;
}

std::string to_string(const PixelBox& box) {
  return std::to_string(box.x) + "," + std::to_string(box.y) + "," + std::to_string(box.width) +
         "x" + std::to_string(box.height);
}

Selection::Selection(int width, int height)
    : width_(width), height_(height), compared_(std::uint64_t(width) * std::uint64_t(height)) {}

void Selection::exclude(std::size_t pixel) {
  if (excluded_.empty()) excluded_.resize(std::size_t(width_) * std::size_t(height_));
  if (excluded_[pixel]) return;
  excluded_[pixel] = true;
  --compared_;
}

Result<void> Selection::exclude(const PixelBox& box) {
  // Computed in 64 bits, because x + width may overflow an int.
  const auto clamp = [](std::int64_t value, int size) {
    return int(std::clamp<std::int64_t>(value, 0, size));
  };
  const int left = clamp(box.x, width_);
  const int right = clamp(std::int64_t(box.x) + box.width, width_);
  const int top = clamp(box.y, height_);
  const int bottom = clamp(std::int64_t(box.y) + box.height, height_);
  if (left >= right || top >= bottom) {
    return fail("--ignore " + to_string(box),
                "the box lies outside of the picture of " + std::to_string(width_) + " x " +
                    std::to_string(height_) + " pixels",
                "count from the top left corner");
  }
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) exclude(index(x, y));
  }
  return {};
}

Result<void> Selection::exclude_black(const StoredImage& mask) {
  if (mask.width != width_ || mask.height != height_) {
    return fail("--mask",
                "the mask has " + std::to_string(mask.width) + " x " + std::to_string(mask.height) +
                    " pixels, the picture " + std::to_string(width_) + " x " +
                    std::to_string(height_),
                "make it as large as the picture");
  }
  for (std::size_t pixel = 0; pixel < mask.pixels(); ++pixel) {
    if (is_black(mask, pixel)) exclude(pixel);
  }
  return {};
}

}  // namespace glassbox
