#include <glassbox/images/stored_image.h>

#include <cstring>
#include <utility>

#include <glassbox/images/pack.h>

namespace glassbox {
namespace {

template <class Pixel>
std::vector<float> floats_of(const Image<Pixel>& image) {
  std::vector<float> samples(image.pixels.size() * sizeof(Pixel) / sizeof(float));
  // The samples are copied as bytes, so that no NaN changes.
  if (!samples.empty()) {
    std::memcpy(samples.data(), image.pixels.data(), samples.size() * sizeof(float));
  }
  return samples;
}

}  // namespace

std::string format_name(const StoredImage& image) {
  constexpr const char* kNames[] = {"8 bits", "16 bits", "32-bit floats"};
  return kNames[image.samples.index()];
}

std::string channel_names(const StoredImage& image) {
  switch (image.channels) {
    case 1:
      return "grey";
    case 2:
      return "grey and alpha";
    case 3:
      return "RGB";
    case 4:
      return "RGBA";
    default:
      return std::to_string(image.channels) + " channels";
  }
}

StoredImage as_stored(const Image<Rgba8>& image) {
  const int channels = is_opaque(image) ? 3 : 4;
  std::vector<std::uint8_t> samples(image.pixels.size() * std::size_t(channels));
  pack_channels(image.pixels, channels, samples.data());
  return {image.width, image.height, channels, std::move(samples)};
}
StoredImage as_stored(const Image<float>& image) {
  return {image.width, image.height, 1, floats_of(image)};
}
StoredImage as_stored(const Image<Rgb32f>& image) {
  return {image.width, image.height, 3, floats_of(image)};
}

}  // namespace glassbox
