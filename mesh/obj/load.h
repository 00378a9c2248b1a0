// Reads Wavefront OBJ and MTL files.
#pragma once

#include <string>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// Reads an OBJ file with the material libraries and colour textures that it names.
//
// Faces keep all their corners. There is one mesh for each combination of object, group and
// material that draws something, in the order of first use, and within it faces keep the file's
// order; each mesh is instanced once, under one root node without a transform.
//
// Choices that the format leaves open:
//   - texture coordinates have v = 0 at the bottom; the scene's are 1 - v. The map_Kd options -s
//     and -o are applied to them: 1 - (s v + o);
//   - vertex colours ("v x y z r g b") are taken as sRGB and rounded to the nearest of its 256
//     codes, whose linear light is known exactly;
//   - Kd and Ks are taken as linear light: in MTL they are reflectivities, which are factors of
//     light. Values outside [0, 1] are clamped. Ke is only clamped at 0, because many programs
//     write more than 1. map_Ke without Ke counts as Ke 1;
//   - "w" of a vertex is the weight of free-form curves and does not move a polygon's corner;
//   - "d" is the opacity, "Tr" one minus it; where both are given, "d" counts. Below 1 a surface
//     blends;
//   - in a file without normals, the faces of a smoothing group ("s 1") get one normal at each
//     vertex, from the sum of the group's Newell vectors there. Faces in no group ("s off", or no
//     "s" before them) are flat. If the file has normals, smoothing groups change nothing;
//   - illum 0 is drawn unlit, illum 1 without highlight;
//   - faces are visible from both sides: the format does not say which is the outside.
//
// The text is parsed here and not by a library, because numbers must become the nearest float on
// every machine, and errors must name the line; tests compare the result with tinyobjloader's.
//
// The file may be hostile: nothing outside its directory is read, and time and memory are
// proportional to the files read, within `limits`. A statement that cannot be drawn as written (an
// index out of range, a coordinate of a drawn vertex that is not a finite number, nothing to draw
// at all) is an error with its line. Something that can be left out (a missing library or texture,
// unknown statements, faces of fewer than three corners, indices of normals in a file without
// normals) is a warning of the scene. Text in UTF-16 is read, too.
Result<Scene> load_obj(const std::string& path, const LoadLimits& limits = {});

// Reads OBJ text in memory, with `mtl` as the only material library. No file is read, so textures
// are missing and "mtllib" lines are ignored.
Result<Scene> load_obj_memory(std::string_view obj_text, std::string_view mtl,
                              const LoadLimits& limits = {});

// Reads OBJ text on its own: no material library is read, which is a warning where the text names
// one.
Result<Scene> load_obj_alone(std::string_view obj_text, const LoadLimits& limits = {});

}  // namespace glassbox
