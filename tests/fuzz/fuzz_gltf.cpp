// Reads any bytes as a glTF or GLB file: the result is an error or a scene, in bounded time and
// memory.
#include <cstddef>
#include <cstdint>
#include <span>

#include <glassbox/mesh/gltf/load.h>
#include <glassbox/mesh/gltf/write.h>

#include "tests/fuzz/promises.h"

namespace {

// check_mesh is not used: normals that have unit length up to round-off are kept as the file has
// them.
void check_scene(const glassbox::Scene& scene) {
  for (const glassbox::Mesh& mesh : scene.meshes) {
    glassbox::fuzz::require(mesh.material < scene.materials.size(), "material in range");
    glassbox::fuzz::check_indices(mesh);
  }
  static_cast<void>(glassbox::encode_glb(scene));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // The limits are small, because an input that may use many resources would look like a hang.
  glassbox::LoadLimits limits;
  limits.max_image_pixels = 1 << 20;
  limits.max_corners = 1 << 20;
  const auto bytes = std::as_bytes(std::span(data, size));
  glassbox::fuzz::check_loaded(glassbox::load_gltf_memory(bytes, "", limits), check_scene);
  return 0;
}
