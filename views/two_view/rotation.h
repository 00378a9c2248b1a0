// Rotations given by three numbers (rotation vectors), and the angle between two rotations.
#pragma once

#include "views/two_view/camera.h"

namespace glassbox::views {

// The rotation about this vector's direction by its length in radians; the identity for the zero
// vector.
Matrix3d turned_by(const Vector3d& rotation_vector);

// The angle between the estimated rotation and the true one, radians.
double rotation_error(const Matrix3d& estimated, const Matrix3d& truth);

}  // namespace glassbox::views
