// The elements of a PLY file as a mesh.
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

struct Built {
  Mesh mesh;
  bool translucent = false;  // some vertex or face has an alpha below 1
};

// Reads all elements behind the header. Errors name the vertex or face, and where in the file it stands; what is read over
// is a warning.
Result<Built> build_mesh(std::string_view file, const Header& header, const LoadLimits& limits,
                         obj::Warnings& warnings);

}  // namespace glassbox::ply
