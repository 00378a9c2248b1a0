// Projections with something else multiplied in: a view, as in the one matrix that many programs hand to a shader.
#pragma once

#include <optional>

#include "app/step/matrices/projection_facts.h"

namespace glassbox {

// A matrix of clip from world taken apart: projection times a rigid view. Nothing where it is not one, or the view would be
// the identity.
struct ProjectionAndView {
  GivenMatrix projection, view;
};
std::optional<ProjectionAndView> factor_projection(const GivenMatrix& matrix);

// The projection itself, where the matrix has a view in it, or has_corner_left_over.
GivenMatrix projection_part(const GivenMatrix& matrix);

// [3][3] of a perspective matrix is the 1 of the identity: its planes are rounder without it than as a projection times a
// view that moves along z.
bool has_corner_left_over(const GivenMatrix& matrix);
GivenMatrix without_corner(const GivenMatrix& matrix);

// The factors in the wrong order, view * projection: the last row is that of the projection, and the first, second and
// fourth columns are perpendicular, as a rotation leaves them, but do not lie along the axes.
bool is_view_times_projection(const glm::dmat4& m);

// Transposed, it is a projection, perhaps with a view in it.
bool is_transposed_projection(const GivenMatrix& matrix);

}  // namespace glassbox
