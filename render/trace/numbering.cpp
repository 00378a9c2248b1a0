#include <glassbox/render/trace/numbering.h>

#include <glassbox/mesh/triangulate.h>

namespace glassbox {

std::uint64_t count_triangles(const Scene& scene, std::uint32_t instance) {
  std::uint64_t count = 0;
  for (const Face& face : scene.meshes[scene.instances[instance].mesh].faces) {
    count += triangle_number_count(face);
  }
  return count;
}

std::uint64_t count_triangles(const Scene& scene) {
  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) count += count_triangles(scene, i);
  return count;
}

std::optional<NumberedTriangle> find_triangle(const Scene& scene, std::uint64_t number) {
  std::uint64_t left = number;
  for (std::uint32_t instance = 0; instance < scene.instances.size(); ++instance) {
    const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
      if (left < triangle_number_count(mesh.faces[face])) {
        return NumberedTriangle{std::uint32_t(number), instance, face};
      }
      left -= triangle_number_count(mesh.faces[face]);
    }
  }
  return std::nullopt;
}

}  // namespace glassbox
