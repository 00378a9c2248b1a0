// Views by the directions in which they lie, seen from the object's middle: which three are around another direction, and how near it is
// to each (S1-40).
//
// The triangles are those of the Delaunay triangulation on the sphere, which is the convex hull of the directions: the faces of it that
// look away from the middle. Their cones fill the cone that all directions span.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "views/two_view/camera.h"

namespace glassbox::views {

struct ViewWeight {
  std::size_t view = 0;
  double weight = 0;
};

// Some views (at most three of a sphere's triangles), whose weights are positive and add up to 1.
using ViewWeights = std::vector<ViewWeight>;

class ViewSphere {
public:
  // Unit vectors, at least one. Of several views within 2^-20 of each other the first is taken. Three directions whose determinant is at most
  // 2^-18 make no triangle: an equal-sided one has sides of 0.12 degrees there. Views nearer to each other than that have none of their own.
  explicit ViewSphere(std::span<const Vector3d> directions);

  // Solves v = sum w_i d_i over the triangle whose cone has v, and divides by the sum of w. The weights depend continuously on v, and a
  // view's own direction has that view alone. A direction beside the cone is carried to the nearest one of the cone, which is continuous
  // too, as the cone is convex; one that is 90 degrees or more from every view has the nearest view.
  ViewWeights weights(const Vector3d& direction) const;

  const std::vector<std::array<std::size_t, 3>>& triangles() const { return triangles_; }
  // Edges of one triangle, and of two views alone.
  const std::vector<std::array<std::size_t, 2>>& border() const { return border_; }

private:
  // Views on one great circle have no triangle: neighbours around it are the border.
  void join_circle(const std::vector<Vector3d>& apart, const std::vector<std::size_t>& number);

  std::vector<Vector3d> directions_;
  std::vector<std::size_t> corners_;  // views that are in a triangle or on the border, or alone
  std::vector<std::array<std::size_t, 3>> triangles_;
  std::vector<std::array<std::size_t, 2>> border_;
};

}  // namespace glassbox::views
