// The parts that the built-in scenes are built from. Each function appends to a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <glassbox/mesh/mesh.h>

namespace glassbox {

// Each of these functions appends an entry to a table of the mesh and returns the entry's index.
std::uint32_t add_position(Mesh& mesh, double x, double y, double z);
// The normal is the direction scaled to unit length.
std::uint32_t add_normal(Mesh& mesh, const Vector<Object, double>& direction);
std::uint32_t add_texcoord(Mesh& mesh, double u, double v);
std::uint32_t add_color(Mesh& mesh, const Rgba& color);

void add_face(Mesh& mesh, std::span<const Corner> corners);

// Appends a flat polygon over existing positions, counter-clockwise seen from its front, with its
// Newell normal. `color` is an index into the mesh's colours or kNone; `texcoords` has one index
// for each position, or none at all.
void add_flat_face(Mesh& mesh, std::span<const std::uint32_t> positions,
                   std::uint32_t color = kNone, std::span<const std::uint32_t> texcoords = {});

// Appends a rectangle with its first corner at `origin` and the sides `u` and `v`,
// counter-clockwise seen from the side to which u x v points. Texture coordinates go from (0,
// repeat_v) at the origin to (repeat_u, 0) at the opposite corner, so that the image is upright.
void add_rectangle(Mesh& mesh, const std::array<double, 3>& origin, const std::array<double, 3>& u,
                   const std::array<double, 3>& v, double repeat_u = 1, double repeat_v = 1);

// Appends the six sides of a box from `low` to `high`, as quads that face outwards. `colors` has an
// index or kNone for each side, as in add_flat_face, in the order -x +x -y +y -z +z.
void add_box(Mesh& mesh, const std::array<double, 3>& low, const std::array<double, 3>& high,
             const std::array<std::uint32_t, 6>& colors = {kNone, kNone, kNone, kNone, kNone,
                                                           kNone});

// Appends the side and the bottom of a cone about the y axis, with its tip at the top and smooth
// normals around the side. The surface is closed.
void add_cone(Mesh& mesh, double radius, double bottom, double top, int sides);

// Appends the side of a prism about the y axis, with smooth normals, open at both ends.
void add_tube(Mesh& mesh, double bottom_radius, double top_radius, double bottom, double top,
              int sides);

}  // namespace glassbox
