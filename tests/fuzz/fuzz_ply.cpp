// Hostile PLY files, text or binary. The first byte chooses limits.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <glassbox/mesh/ply/load.h>

namespace {

// What loaders guarantee (mesh/mesh.h), so that later stages need not check.
void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "the loaded scene breaks a promise: %s\n", what);
  std::abort();
}

template <class Table>
bool in_range_or_none(std::uint32_t index, const Table& table) {
  return index == glassbox::kNone || index < table.size();
}

void check_corner(const glassbox::Corner& corner, const glassbox::Mesh& mesh) {
  require(corner.position < mesh.positions.size(), "position in range");
  require(in_range_or_none(corner.normal, mesh.normals), "normal in range");
  require(in_range_or_none(corner.texcoord, mesh.texcoords), "texture coordinate in range");
  require(in_range_or_none(corner.color, mesh.colors), "colour in range");
}

void check_mesh(const glassbox::Mesh& mesh) {
  for (const auto& p : mesh.positions) {
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "finite position");
  }
  for (const auto& n : mesh.normals) {
    const double length = std::sqrt(double(n.x) * double(n.x) + double(n.y) * double(n.y) +
                                    double(n.z) * double(n.z));
    // Each component is off by half an ulp at most, 2^-25.
    require(std::abs(length - 1) < 0x1p-23, "unit normal");
  }
  for (const auto& t : mesh.texcoords) {
    require(std::isfinite(t.u) && std::isfinite(t.v), "finite texture coordinate");
  }
  for (const auto& c : mesh.colors) {
    for (const float channel : {c.r, c.g, c.b, c.a}) {
      require(channel >= 0 && channel <= 1, "colour in [0, 1]");
    }
  }
  for (const auto& face : mesh.faces) {
    require(face.count >= 3, "three corners");
    require(face.first <= mesh.corners.size() && face.count <= mesh.corners.size() - face.first,
            "face in range");
  }
  for (const auto& corner : mesh.corners) check_corner(corner, mesh);
  for (const auto& line : mesh.lines) {
    for (const auto& corner : line) check_corner(corner, mesh);
  }
  for (const auto& corner : mesh.points) check_corner(corner, mesh);
}

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
  const auto scene = glassbox::load_ply_memory(file, limits);
  if (scene) {
    check_scene(*scene);
  } else {
    require(!scene.error().cause.empty() && !scene.error().remedy.empty(), "cause and remedy");
    require(scene.error().message().find('\n') == std::string::npos, "one line");
  }
  return 0;
}
