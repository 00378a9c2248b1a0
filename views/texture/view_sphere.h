// Views sorted by their directions, seen from the object's middle: finds the three views around
// another direction, and how near it is to each (S1-40).
//
// The triangles are those of the Delaunay triangulation on the sphere. These are the faces of the
// directions' convex hull that look away from the middle. Their cones fill the cone that all
// directions span.
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

// Some views (at most three: the corners of a triangle of the sphere), whose weights are positive
// and sum to 1.
using ViewWeights = std::vector<ViewWeight>;

class ViewSphere {
public:
  // Unit vectors, at least one. If views are within 2^-20 of each other, the first is taken. Three
  // directions whose determinant is at most 2^-18 make no triangle: an equilateral triangle with
  // this determinant has sides of 0.12 degrees. Views nearer to each other than that have no
  // triangle of their own.
  explicit ViewSphere(std::span<const Vector3d> directions);

  // Solves v = sum w_i d_i for the direction v and the directions d_i of the three views whose
  // triangle's cone contains v, and divides the weights w_i by their sum. The weights depend
  // continuously on v, and a view's own direction has only that view. A direction outside of the
  // cone of all views is replaced by the nearest one in the cone, which is continuous too, as the
  // cone is convex. A direction that is 90 degrees or more from every view has only the nearest
  // view.
  ViewWeights weights(const Vector3d& direction) const;

  const std::vector<std::array<std::size_t, 3>>& triangles() const { return triangles_; }
  // Edges that belong to only one triangle, and edges between two views without a triangle.
  const std::vector<std::array<std::size_t, 2>>& border() const { return border_; }

private:
  // Views on one great circle have no triangle: the border consists of the pairs of neighbours
  // around it.
  void join_circle(const std::vector<Vector3d>& distinct, const std::vector<std::size_t>& number);

  std::vector<Vector3d> directions_;
  std::vector<std::size_t> corners_;  // the first view of each direction
  std::vector<std::array<std::size_t, 3>> triangles_;
  std::vector<std::array<std::size_t, 2>> border_;
};

}  // namespace glassbox::views
