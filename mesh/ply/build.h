// Converts the elements of a PLY file to a mesh.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/input/text.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/mesh.h>
#include <glassbox/mesh/ply/header.h>

namespace glassbox::ply {

struct PlyMesh {
  Mesh mesh;
  bool translucent = false;  // some vertex or face has an alpha below 1
};

// Reads all elements after the header. Errors name the vertex or face and its place in the file;
// things that are ignored are warnings.
Result<PlyMesh> build_mesh(std::string_view file, const Header& header, const LoadLimits& limits,
                           obj::Warnings& warnings);

}  // namespace glassbox::ply
