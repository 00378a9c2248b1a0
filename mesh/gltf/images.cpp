#include <glassbox/mesh/gltf/images.h>

#include <memory>
#include <span>

#include <glassbox/images/decode.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {

ImageTable::ImageTable(Asset& asset, Scene& scene)
    : asset_(asset),
      scene_(scene),
      known_(asset.document.value("images", nlohmann::json::array()).size()),
      pixels_left_(asset.limits.max_image_pixels) {}

Result<std::uint32_t> ImageTable::add(std::size_t index) {
  if (known_[index]) return *known_[index];
  auto image = image_file(asset_, asset_.document["images"][index]).and_then([&](const auto& file) {
    return decode_image(file.bytes, {pixels_left_, asset_.limits.max_image_side});
  });
  if (!image) {
    const Error& error = image.error();
    const std::string place = error.place.empty() ? "" : error.place + ": ";
    return fail(entry("image", index), place + error.cause, error.remedy);
  }
  pixels_left_ -= image->pixels.size();
  known_[index] = std::uint32_t(scene_.images.size());
  scene_.images.push_back(std::move(*image));
  return *known_[index];
}

}  // namespace glassbox::gltf
