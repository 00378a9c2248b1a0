// Wavefront OBJ and MTL files in.
#pragma once

#include <string>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// Reads an OBJ file with the material libraries and colour textures it names.
//
// Faces keep all their corners. There is one mesh for each combination of object, group and
// material that draws something, in the order of first use, and within it faces keep the file's
// order; each mesh is instanced once, under one root node without a transform.
//
// Conventions that the format leaves open:
//   - texture coordinates have v = 0 at the bottom; the scene's are 1 - v. The map_Kd options -s and
//     -o are applied to them: 1 - (s v + o);
//   - vertex colours ("v x y z r g b") are taken as sRGB and rounded to the nearest of its 256
//     codes, whose light is known exactly;
//   - Kd and Ks are taken as linear light: MTL speaks of reflectivities, and those are factors of
//     light. Values outside [0, 1] are clamped. Ke, of which many programs write more than 1, only at 0. map_Ke
//     without Ke counts as Ke 1;
//   - "w" of a vertex is the weight of free-form curves and does not move a polygon's corner;
//   - "d" is the opacity, "Tr" one minus it; where both stand, "d" counts. Below 1 a surface blends;
//   - illum 0 is drawn unlit, illum 1 without highlight;
//   - faces are seen from both sides: the format does not say which is the outside.
//
// The text is read here and not by a library, because numbers must become the nearest float on
// every machine, and errors must name the line; tests compare the result with tinyobjloader's.
//
// The file is taken to be hostile: nothing outside its directory is read, time and memory stay in
// proportion to the files read, within `limits`. A statement that cannot be drawn as written (an
// index out of range, a coordinate that is no finite number, nothing to draw at all) is an error
// with its line. What can be drawn without (a missing library or texture, unknown statements, faces
// of fewer than three corners, indices of normals in a file without normals) is a warning of the
// scene.
Result<Scene> load_obj(const std::string& path, const LoadLimits& limits = {});

// Reads OBJ text in memory, with `mtl` as the only material library; no file is read, so that textures
// are missing and "mtllib" lines are passed over.
Result<Scene> load_obj_memory(std::string_view obj_text, std::string_view mtl,
                              const LoadLimits& limits = {});

// Reads OBJ text that is all there is: no material library is read, which is a warning where the text names one.
Result<Scene> load_obj_alone(std::string_view obj_text, const LoadLimits& limits = {});

}  // namespace glassbox
