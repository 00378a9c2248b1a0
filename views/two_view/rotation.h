// Rotations as three numbers, and how far two of them are apart.
#pragma once

#include "views/two_view/camera.h"

namespace glassbox::views {

// By this vector's length in radians around its direction; none around 0.
Matrix3d turned_by(const Vector3d& rotation_vector);

// The angle between what was estimated and what is, radians.
double rotation_error(const Matrix3d& estimated, const Matrix3d& truth);

}  // namespace glassbox::views
