// Reads hostile OBJ and MTL text. The first byte chooses limits; after a line "%%MTL" the material
// library begins.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <glassbox/mesh/obj/load.h>

#include "tests/fuzz/promises.h"

namespace {

using glassbox::fuzz::check_mesh;
using glassbox::fuzz::require;

void check_scene(const glassbox::Scene& scene) {
  require(!scene.materials.empty() && !scene.meshes.empty(), "something to draw");
  require(scene.nodes.size() == 1 && scene.instances.size() == scene.meshes.size(), "placement");
  for (const auto& mesh : scene.meshes) {
    require(mesh.material < scene.materials.size(), "material in range");
    check_mesh(mesh);
  }
  for (const auto& material : scene.materials) {
    require(!material.texture, "no texture from memory");
    require(material.shininess >= 1 && material.shininess <= 1024, "exponent in range");
    for (const float channel : {material.base_color.r, material.base_color.g, material.base_color.b,
                                material.base_color.a, material.specular[0], material.specular[1],
                                material.specular[2]}) {
      require(channel >= 0 && channel <= 1, "material in [0, 1]");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  glassbox::LoadLimits limits;
  if ((data[0] & 1) != 0) limits.max_corners = 64;
  if ((data[0] & 2) != 0) limits.max_file_bytes = 256;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  constexpr std::string_view kSeparator = "%%MTL\n";
  const std::size_t split = text.find(kSeparator);
  const std::string_view obj = text.substr(0, split);
  const std::string_view mtl =
      split == std::string_view::npos ? std::string_view() : text.substr(split + kSeparator.size());
  glassbox::fuzz::check_loaded(glassbox::load_obj_memory(obj, mtl, limits), check_scene);
  return 0;
}
