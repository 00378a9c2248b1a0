// Reads hostile PLY files, text or binary. The first byte chooses limits.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <glassbox/mesh/ply/load.h>

#include "tests/fuzz/promises.h"

namespace {

using glassbox::fuzz::check_mesh;
using glassbox::fuzz::require;

void check_scene(const glassbox::Scene& scene) {
  require(scene.materials.size() == 1 && scene.meshes.size() == 1, "one mesh");
  require(scene.nodes.size() == 1 && scene.instances.size() == 1, "placement");
  require(!scene.materials[0].texture, "no texture from memory");
  require(!scene.meshes[0].faces.empty(), "something to draw");
  check_mesh(scene.meshes[0]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  glassbox::LoadLimits limits;
  if ((data[0] & 1) != 0) limits.max_corners = 64;
  if ((data[0] & 2) != 0) limits.max_file_bytes = 256;
  const std::string_view file(reinterpret_cast<const char*>(data + 1), size - 1);
  glassbox::fuzz::check_loaded(glassbox::load_ply_memory(file, limits), check_scene);
  return 0;
}
