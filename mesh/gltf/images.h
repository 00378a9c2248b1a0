// Images of a glTF file, decoded when something that is drawn needs them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

class ImageTable {
public:
  ImageTable(Asset& asset, Scene& scene);

  // Returns the index in Scene::images of an image of the file; the image is decoded on the first
  // call. All images together must stay within the limit on pixels.
  Result<std::uint32_t> add(std::size_t index);

private:
  Asset& asset_;
  Scene& scene_;
  std::vector<std::optional<std::uint32_t>> known_;
  std::uint64_t pixels_left_;
};

}  // namespace glassbox::gltf
