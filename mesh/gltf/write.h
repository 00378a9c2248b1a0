// Writes scenes as GLB files.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// Writes the scene so that load_gltf restores everything that is drawn bit by bit: matrices,
// positions, normals, texture coordinates, colours, the order of instances and triangles,
// materials, cameras and lights. Polygons are written as the triangles of triangulate(). Errors: a
// camera with a FrustumLens (glTF has none), a triangle with normals on only some of its corners,
// numbers that are not finite, a file that cannot be written.
Result<void> write_glb(const Scene& scene, const std::string& path);

// Returns the bytes of the file that write_glb writes.
Result<std::vector<std::byte>> encode_glb(const Scene& scene);

// An upper bound of the memory for writing, in bytes per triangle that shares no corner with
// another, in addition to the scene and its pictures. While equal corners are searched, each of the
// triangle's three corners takes 108 bytes: a table node of 48 bytes, two tables of pointers for
// each node, and the corner itself and its number, with at most twice the necessary capacity. While
// the file is assembled, which needs more, a corner takes 32 bytes (a position, a colour and a
// number) four times: twice as it is collected, with at most twice the necessary capacity, once in
// the file's order, and once more for the result. The sum is 3 * 4 * 32 = 384.
inline constexpr double kGlbBytesOfTriangle = 384;

}  // namespace glassbox
