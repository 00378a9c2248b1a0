// Finds projections that are multiplied with another matrix, such as the view: many programs give a
// shader one matrix for both.
#pragma once

#include <optional>

#include <glassbox/matrices/projection_facts.h>

namespace glassbox {

// A matrix clip_from_world, split into a projection times a rigid view. factor_projection returns
// nothing if that is not possible, or if the view would be the identity.
struct ProjectionAndView {
  GivenMatrix projection, view;
};
std::optional<ProjectionAndView> factor_projection(const GivenMatrix& matrix);

// The projection alone: without the view if the matrix contains one, and without a corner left
// over.
GivenMatrix projection_part(const GivenMatrix& matrix);

// Whether [3][3] of a perspective matrix is a 1 that is probably left over from an identity matrix:
// the near and far planes are rounder without it than if the matrix is read as a projection times a
// view that moves along z, or it cannot be read so.
bool has_corner_left_over(const GivenMatrix& matrix);
GivenMatrix without_corner(const GivenMatrix& matrix);

// Whether the matrix is view * projection, with the factors in the wrong order. Then the last row
// is that of the projection, and the first, second and fourth columns are perpendicular, because a
// rotation keeps them so, but not along the axes.
bool is_view_times_projection(const glm::dmat4& m);

// Whether the transposed matrix is a projection, perhaps multiplied with a view.
bool is_transposed_projection(const GivenMatrix& matrix);

}  // namespace glassbox
