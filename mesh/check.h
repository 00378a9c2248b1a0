// The contents of a mesh and its faults: the findings that `glassbox info` prints.
#pragma once

#include <cstdint>
#include <optional>

#include <glassbox/base/box.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox {

struct MeshReport {
  std::uint32_t positions = 0;
  std::uint32_t vertices = 0;  // used by faces; positions at the same place are counted once
  std::uint32_t faces = 0;
  std::uint32_t triangles = 0;  // the triangles that are drawn
  std::uint32_t lines = 0;
  std::uint32_t points = 0;
  Box<Object> bounds;
  double area = 0;  // of all faces, square object units

  // Adjacency, with positions at the same place welded (mesh/topology.h).
  std::uint32_t edges = 0;
  std::uint32_t open_edges = 0;
  std::uint32_t non_manifold_edges = 0;
  std::uint32_t inconsistent_edges = 0;
  std::uint32_t pinched_vertices = 0;
  std::uint32_t unused_positions = 0;
  std::uint32_t components = 0;
  std::int64_t euler_characteristic = 0;
  bool closed = false;
  std::optional<std::uint32_t> genus;  // where the mesh is a closed oriented surface

  // Faults of faces.
  std::uint32_t degenerate_faces = 0;  // dropped because they have no area
  // Triangles without area, which were dropped from faces that are kept.
  std::uint32_t degenerate_triangles = 0;
  std::uint32_t self_intersecting_faces = 0;
  // Quads among the faces without area and those that cross themselves that are proper quads if
  // their last two corners are exchanged: they were listed row by row, as in the letter Z.
  std::uint32_t quads_in_z_order = 0;
  // Faces with the same vertices as an earlier face, in the same or the opposite direction.
  std::uint32_t duplicate_faces = 0;
  std::uint32_t non_planar_faces = 0;
  double worst_planarity_deviation = 0;  // object units
  std::uint32_t worst_planarity_face = kNone;

  // Whether there is no fault that a modeller should know about. Open edges are not a fault by
  // themselves.
  bool clean() const {
    return non_manifold_edges == 0 && inconsistent_edges == 0 && pinched_vertices == 0 &&
           unused_positions == 0 && degenerate_faces == 0 && degenerate_triangles == 0 &&
           self_intersecting_faces == 0 && duplicate_faces == 0 && non_planar_faces == 0;
  }
};

// A face counts as non-planar if a corner is further from its mean plane than rounding a flat
// face's corners to float can move it: 2^-22 of the largest coordinate of the face. (Half an ulp in
// each of three coordinates moves the corner by less than 2^-23 of that coordinate, and the mean
// plane can move as far in the other direction.)
MeshReport mesh_report(const Mesh& mesh);

}  // namespace glassbox
