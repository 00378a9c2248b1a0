// A picture in memory, as the code under test has it. Nothing of Glassbox is needed to describe
// one: this header includes only the standard library, and C++17 is enough.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

namespace glassbox {

// Glassbox's own pictures. Whoever has one includes glassbox/images/image.h or stored_image.h.
template <class Pixel>
struct Image;
struct Rgba8;
struct Rgb32f;
struct StoredImage;

// The samples belong to somebody else, and must live as long as the view.
struct PictureView {
  int width = 0;     // px
  int height = 0;    // px
  int channels = 0;  // 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA; of floats 1 or 3
  // The first sample of the top row. The channels of a pixel lie together.
  std::variant<const std::uint8_t*, const std::uint16_t*, const float*> samples;
  // How many samples there are from the beginning of a row to that of the row below it. 0 stands
  // for width * channels: nothing lies between the rows. It is negative where the bottom row comes
  // first in memory, as glReadPixels stores it.
  std::ptrdiff_t row_step = 0;
};

// A test may compare every type for which there is such a function. Write one in the namespace of
// your own type.
inline PictureView picture_view(const PictureView& view) {
  return view;
}

template <class Pixel>
PictureView picture_view(const Image<Pixel>& image) {
  const void* pixels = image.pixels.data();
  if constexpr (std::is_same_v<Pixel, float>) {
    return {image.width, image.height, 1, static_cast<const float*>(pixels)};
  } else if constexpr (std::is_same_v<Pixel, Rgb32f>) {
    return {image.width, image.height, 3, static_cast<const float*>(pixels)};
  } else {
    static_assert(std::is_same_v<Pixel, Rgba8>, "an Image has pixels of Rgba8, Rgb32f or float");
    return {image.width, image.height, 4, static_cast<const std::uint8_t*>(pixels)};
  }
}

// A template, because StoredImage is known only where the function is called. The view of an image
// that has fewer samples than its size needs has none, and is refused.
template <class Stored, std::enable_if_t<std::is_same_v<Stored, StoredImage>, int> = 0>
PictureView picture_view(const Stored& image) {
  PictureView view{image.width, image.height, image.channels, {}};
  const std::size_t needed = image.pixels() * std::size_t(image.channels);
  std::visit(
      [&](const auto& samples) {
        view.samples = samples.size() < needed ? nullptr : samples.data();
      },
      image.samples);
  return view;
}

// Whether there is a picture_view for this type.
template <class Picture, class = void>
inline constexpr bool has_picture_view = false;
template <class Picture>
inline constexpr bool
    has_picture_view<Picture, std::void_t<decltype(picture_view(std::declval<const Picture&>()))>> =
        true;

}  // namespace glassbox
