// Finds projections that are multiplied with another matrix, such as the view: many programs give a
// shader one matrix for both.
#pragma once

#include <optional>

#include <glassbox/matrices/projection_facts.h>

namespace glassbox {

// Splits a matrix clip_from_world into a projection times a rigid view. Nothing if that is not
// possible, or if the view would be the identity.
struct ProjectionAndView {
  GivenMatrix projection, view;
};
std::optional<ProjectionAndView> factor_projection(const GivenMatrix& matrix);

// The projection itself, if the matrix contains a view or has_corner_left_over.
GivenMatrix projection_part(const GivenMatrix& matrix);

// Whether [3][3] of a perspective matrix is a 1 left over from an identity matrix. It is taken for
// one if the near and far planes are rounder without it than if the matrix is read as a projection
// times a view that moves along z.
bool has_corner_left_over(const GivenMatrix& matrix);
GivenMatrix without_corner(const GivenMatrix& matrix);

// Whether the factors are in the wrong order, view * projection. Then the last row is that of the
// projection, and the first, second and fourth columns are perpendicular, as a rotation leaves
// them, but not along the axes.
bool is_view_times_projection(const glm::dmat4& m);

// Whether the transposed matrix is a projection, perhaps multiplied with a view.
bool is_transposed_projection(const GivenMatrix& matrix);

}  // namespace glassbox
