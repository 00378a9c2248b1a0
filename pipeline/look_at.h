// World space to eye space, in both constructions of the slides. The eye looks down -z with y up.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>

namespace glassbox {

// If the sine of the angle between `up` and the gaze is below this value (0.2 seconds of arc), the
// up direction is undetermined: the error of the axes is about 2 u/sine (u is the unit roundoff,
// 2^-53; B.5), and the user cannot have meant it (C-01).
inline constexpr double kMinUpSine = 0x1p-20;

// The position and the axes of an eye: the columns are U = up x N/|up x N|, V = N x U and N =
// -gaze/|gaze|, and the eye is the origin (S4.6). The vectors may have any length. Errors: a zero,
// infinite or NaN gaze or up, an eye that is not finite, `up` along the gaze.
Result<Transform<World, Eye>> camera_pose(const Point<World, double>& eye,
                                          const Vector<World, double>& gaze,
                                          const Vector<World, double>& up);
// The pose of an eye that looks at the point `target`; it is an error if `target` is the eye
// (C-02).
Result<Transform<World, Eye>> camera_pose(const Point<World, double>& eye,
                                          const Point<World, double>& target,
                                          const Vector<World, double>& up);

// The UVN construction, as in gluLookAt (S4-02, S4-03): [[U, -e.U], [V, -e.V], [N, -e.N], [0 0 0
// 1]], the inverse of camera_pose. The rotation's entries are within (8 + 4/sine) u of the exact
// ones, where u is the unit roundoff and `sine` the sine of the angle between up and gaze.
// Axis-aligned cameras are exact, and there is no -0.
Result<Transform<Eye, World>> look_at(const Point<World, double>& eye,
                                      const Point<World, double>& target,
                                      const Vector<World, double>& up);

// The construction of S3.37: translate by -eye, rotate the gaze v onto -z about the axis a = v x
// (-z), then roll about z until up is in the upper half of the yz plane: R_z(roll) R(a, theta)
// T(-eye). (The slide turns the gaze to +z, which mirrors the picture in a right-handed world: E7.)
// The result agrees with look_at within the sum of their errors. For a gaze along +z, where a is
// 0/0, the rotation is about y (E8, C-05).
Result<Transform<Eye, World>> look_at_axis_angle(const Point<World, double>& eye,
                                                 const Point<World, double>& target,
                                                 const Vector<World, double>& up);

}  // namespace glassbox
