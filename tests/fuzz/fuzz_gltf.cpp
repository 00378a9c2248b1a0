// Any bytes as a glTF or GLB file: an error or a scene, in bounded time and memory.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include <glassbox/mesh/gltf/load.h>
#include <glassbox/mesh/gltf/write.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Small limits, so that an input that is allowed much does not look like a hang.
  glassbox::LoadLimits limits;
  limits.max_image_pixels = 1 << 20;
  limits.max_corners = 1 << 20;
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto scene = glassbox::load_gltf_memory(bytes, "", limits);
  if (!scene) {
    if (scene.error().cause.empty() || scene.error().message().find('\n') != std::string::npos)
      std::abort();
    return 0;
  }
  // What the loader promises to later stages.
  for (const glassbox::Mesh& mesh : scene->meshes) {
    if (mesh.material >= scene->materials.size()) std::abort();
    for (const glassbox::Corner& c : mesh.corners) {
      if (c.position >= mesh.positions.size()) std::abort();
      if (c.normal != glassbox::kNone && c.normal >= mesh.normals.size()) std::abort();
      if (c.texcoord != glassbox::kNone && c.texcoord >= mesh.texcoords.size()) std::abort();
      if (c.color != glassbox::kNone && c.color >= mesh.colors.size()) std::abort();
    }
  }
  static_cast<void>(glassbox::encode_glb(*scene));
  return 0;
}
