// The view matrix built as in the slides: move the eye to the origin, turn the gaze to -z, then
// roll until `up` is upright (S3-16).
#pragma once

#include <glassbox/base/spaces.h>

namespace glassbox {

// The factor (1 - cosine)/sine^2 of Rodrigues' formula, without cancellation for either sign of the
// cosine. sine_squared must be > 0.
inline double rodrigues_factor(double cosine, double sine_squared) {
  return cosine > 0 ? 1 / (1 + cosine) : (1 - cosine) / sine_squared;
}

// The three factors of a view: the view is roll * rotation * translation.
struct AxisAngleFactors {
  Transform<World, World> translation;  // T(-eye)
  // R(a, theta) about a = gaze x (-z), whose length is the sine of theta.
  Transform<World, World> rotation;
  Transform<Eye, World> roll;  // R_z(roll): turns up into the upper half of the yz plane
};

// `gaze` and `up` are unit vectors that are not on one line. For a gaze along +z the axis of the
// rotation to -z would be 0/0; then it is a half turn about y (E8, C-05).
AxisAngleFactors axis_angle_factors(const Point<World, double>& eye,
                                    const Vector<World, double>& gaze,
                                    const Vector<World, double>& up);

// The product (roll * rotation) * translation, in which -0 is replaced by 0.
Transform<Eye, World> product(const AxisAngleFactors& factors);

}  // namespace glassbox
