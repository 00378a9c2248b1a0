#include <glassbox/compare/pixels/canvas.h>

#include <algorithm>

namespace glassbox {
namespace {

// The place of the test's top left corner in the reference's pixels.
PixelPosition place_of_test(const StoredImage& reference, const StoredImage& test,
                            Alignment alignment) {
  if (alignment == Alignment::kTopLeft) return {};
  if (alignment == Alignment::kBest) return best_place(reference, test);
  return {(reference.width - test.width) / 2, (reference.height - test.height) / 2};
}

}  // namespace

Canvas place_on_canvas(const StoredImage& reference, const StoredImage& test, Alignment alignment) {
  const int width = std::max(reference.width, test.width);
  const int height = std::max(reference.height, test.height);
  // No side of a picture that is read is longer than max_side, so no canvas is too large.
  static_assert(std::uint64_t(kCompareLimits.max_side) * kCompareLimits.max_side <=
                kCompareLimits.max_pixels);
  const auto [x, y] = place_of_test(reference, test, alignment);
  return Canvas{width,
                height,
                {std::max(-x, 0), std::max(-y, 0), reference.width, reference.height},
                {std::max(x, 0), std::max(y, 0), test.width, test.height}};
}

StoredImage on_canvas(StoredImage image, const Canvas& canvas, const PixelBox& place) {
  if (place.width == canvas.width && place.height == canvas.height) return image;
  StoredImage whole{canvas.width, canvas.height, image.channels, {}};
  const auto channels = std::size_t(image.channels);
  std::visit(
      [&](const auto& samples) {
        std::decay_t<decltype(samples)> all(whole.pixels() * channels);
        const std::size_t row = std::size_t(image.width) * channels;
        for (int y = 0; y < image.height; ++y) {
          const std::size_t to =
              std::size_t(place.y + y) * std::size_t(canvas.width) + std::size_t(place.x);
          std::copy_n(samples.begin() + std::ptrdiff_t(std::size_t(y) * row), row,
                      all.begin() + std::ptrdiff_t(to * channels));
        }
        whole.samples = std::move(all);
      },
      image.samples);
  return whole;
}

Selection on_canvas(const Selection& own, const Canvas& canvas) {
  Selection selection(canvas.width, canvas.height);
  const auto [left, top, width, height] = canvas.overlap();
  for (int y = 0; y < canvas.height; ++y) {
    for (int x = 0; x < canvas.width; ++x) {
      const bool shared = left <= x && x < left + width && top <= y && y < top + height;
      if (!shared || !own.compares(x - canvas.reference.x, y - canvas.reference.y)) {
        selection.exclude(x, y);
      }
    }
  }
  return selection;
}

}  // namespace glassbox
