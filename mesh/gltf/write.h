// Scenes out as GLB files.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// Writes the scene so that load_gltf gives back what is drawn bit by bit: matrices, positions, normals, texture
// coordinates, colours, the order of instances and triangles, materials, cameras and lights. Polygons are written as the
// triangles that triangulate() gives. Errors: a camera with a FrustumLens (glTF has none), a triangle with normals on
// some of its corners only, numbers that are not finite, a file that cannot be written.
Result<void> write_glb(const Scene& scene, const std::string& path);

// The bytes of that file.
Result<std::vector<std::byte>> encode_glb(const Scene& scene);

// What writing takes at most, beside the scene and its pictures, of a triangle that shares no corner with another: while equal corners are
// looked for a table's node, 48 bytes, and two tables of pointers for each, and itself and its number, with at most twice as much room as they need,
// 108 in all for one of three; while the file is put together a place, a colour and a number, 32 for one of three, as they are gathered, at
// most twice as much room, in the file's order, and once more: 384.
inline constexpr double kGlbBytesOfTriangle = 384;

}  // namespace glassbox
