// Reads PLY files, the polygon format of Stanford's scans (Greg Turk, 1994).
#pragma once

#include <string>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// Reads an ascii, binary_little_endian or binary_big_endian file: one mesh of polygons, with all
// their corners.
//
//   vertex  x y z; nx ny nz; red green blue [alpha];
//           u v, s t, texture_u texture_v or texture_s texture_t
//   face    a list vertex_indices or vertex_index; red green blue [alpha] where the vertices
//           have no colours; a list texcoord of u and v for each corner
//   tristrips  a list vertex_indices of triangle strips, where -1 ends a strip
//
// Choices that the format leaves open, made as for OBJ files: colours are sRGB, rounded to one of
// its 256 codes, and their range follows from their type and their largest number
// (mesh/ply/colors.h); v = 0 is the bottom of a texture, which "comment TextureFile NAME" names and
// which must be in the file's own directory; faces are visible from both sides. An alpha below 1
// blends; where all alphas are 0, they were never set, and they are ignored with a warning.
//
// The file may be hostile: counts are compared with the bytes that exist before anything is
// allocated, and time and memory are proportional to the file, within `limits`. A position of a
// drawn vertex that is not finite, an index out of range and a file without faces (a point cloud)
// are errors that name the vertex, the face and the place in the file. Elements and properties that
// are not drawn, and faces of fewer than three corners, are warnings of the scene.
Result<Scene> load_ply(const std::string& path, const LoadLimits& limits = {});

// Reads a PLY file in memory, where no texture can be read.
Result<Scene> load_ply_memory(std::string_view bytes, const LoadLimits& limits = {});

}  // namespace glassbox
