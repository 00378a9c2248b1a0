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

}  // namespace glassbox
