#include "views/voxels/voxel_file.h"

#include <algorithm>
#include <bit>
#include <unordered_set>

#include <fmt/format.h>

namespace glassbox::views {

namespace {

void add_bytes(std::string& text, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) text += char(value >> (8 * k) & 0xffu);
}

void add_vertex(std::string& text, const Vector3d& p, const Rgba8& color) {
  for (int axis = 0; axis < 3; ++axis)
    add_bytes(text, std::bit_cast<std::uint32_t>(float(p[axis])));
  text += char(color.r);
  text += char(color.g);
  text += char(color.b);
}

struct Side {
  VoxelPosition beside;
  // The side's corners, counter-clockwise seen from outside. In a corner's number, bit 0 is set at
  // high x, bit 1 at high y, and bit 2 at high z.
  int corners[4];
};
constexpr Side kSides[] = {{{-1, 0, 0}, {0, 4, 6, 2}}, {{1, 0, 0}, {1, 3, 7, 5}},
                           {{0, -1, 0}, {0, 1, 5, 4}}, {{0, 1, 0}, {2, 6, 7, 3}},
                           {{0, 0, -1}, {0, 2, 3, 1}}, {{0, 0, 1}, {4, 5, 7, 6}}};

}  // namespace

std::string voxels_ply(const VoxelGrid& grid, const std::vector<ColoredVoxel>& voxels,
                       VoxelShape shape) {
  const bool has_faces = shape == VoxelShape::kCubes;
  std::string vertices, faces;
  std::size_t vertex_count = 0, face_count = 0;
  std::unordered_set<std::uint64_t> colored;
  if (has_faces) {
    colored.reserve(voxels.size());
    for (const ColoredVoxel& voxel : voxels) colored.insert(key_of(voxel.at));
  }
  for (const ColoredVoxel& voxel : voxels) {
    const VoxelPosition& at = voxel.at;
    if (!has_faces) {
      add_vertex(vertices, grid.centre(at), voxel.color);
      ++vertex_count;
      continue;
    }
    for (const Side& side : kSides) {
      if (colored.contains(
              key_of({at.x + side.beside.x, at.y + side.beside.y, at.z + side.beside.z})))
        continue;
      faces += char(4);
      for (const int corner : side.corners) {
        add_vertex(vertices,
                   grid.world(at.x + (corner & 1), at.y + (corner >> 1 & 1), at.z + (corner >> 2)),
                   voxel.color);
        add_bytes(faces, std::uint32_t(vertex_count++));
      }
      ++face_count;
    }
  }
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment made by glassbox views voxels\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n",
      vertex_count);
  if (has_faces)
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", face_count);
  return text + "end_header\n" + vertices + faces;
}

}  // namespace glassbox::views
