// Lab 3: from world to eye space. The contracts of the five functions that you write in
// student.cpp.
//
// Both spaces are right-handed. In eye space the eye is at the origin, x is right, y is up, and it
// looks down -z. Column vectors: p_eye = eye_from_world * p_world. Everything is in double;
// u = 2^-53 is its unit roundoff.
#pragma once

#include <optional>

#include <glassbox/base/spaces.h>

namespace lab_03 {

// The types of <glassbox/base/spaces.h>, which comes with glassbox; this is all that you need:
//   Point<Space, double>       p.x, p.y, p.z; p - q is a Vector, p + v a Point
//   Vector<Space, double>      v.x, v.y, v.z; v + w, v - w, -v, v * number; dot(v, w), cross(v, w)
//   Transform<Target, Source>  a 4 x 4 matrix of doubles, at first the identity: m.at(row, column),
//                              counted from 0; m * p, m * v; a * b: a Transform<C, B> times a
//                              Transform<B, A> is a Transform<C, A>
using glassbox::Clip;
using glassbox::Eye;
using glassbox::Point;
using glassbox::Transform;
using glassbox::Vector;
using glassbox::World;

// The position of the eye, the point that it looks at, and a direction (of any length) that is up
// in the picture.
struct Camera {
  Point<World, double> eye{0, 0, 0};
  Point<World, double> target{0, 0, -1};
  Vector<World, double> up{0, 1, 0};
};

// Task 3.1. The view matrix from the axes U, V, N of the eye. Returns std::nullopt where there is
// no such matrix: the target is the eye, `up` is zero or along the gaze (the sine of the angle
// between them is below 2^-20), or a number is infinite or NaN. The gaze and `up`, if they are not
// zero, have lengths between 10^-100 and 10^100. In all cameras that are tested, the sine differs
// from 2^-20 by more than 2^-48, so that its rounding does not matter.
// Error bound of each entry of the rotation: 32 u (1 + 1/s), where s is the sine of the angle
// between `up` and the gaze. Error bound of the last column: the bound of the rotation times
// (1 + 2 D), where D is the largest coordinate of the eye in size.
std::optional<Transform<Eye, World>> uvn_view(const Camera& camera);

// Task 3.2. The rotation by the smallest angle that turns the direction `from` into the direction
// `to`. Neither is zero, and they may have any length: their components may be as small as 2^-1074,
// or as large as 2^1023. If the directions are the same, it is the identity. If they are opposite,
// it is half a turn about any axis perpendicular to them (then their lengths are equal, or both are
// along x, y or z, so that the cross product is exactly zero).
// Error bound of each entry: 64 u up to a right angle, 32 u (1 + 1/s) beyond it, where s is the
// sine of the angle. For half a turn instead: the entries of R^T R - I are up to 16 u, and R maps
// from / |from| to within 16 u of to / |to|.
Transform<World, World> rotation_onto(const Vector<World, double>& from,
                                      const Vector<World, double>& to);

// Task 3.3. The same matrix as that of uvn_view, by two rotations: first the gaze onto -z by the
// smallest angle, then about z until `up` is in the upper half of the yz plane. The camera is one
// that has a view matrix. A gaze along +z must work too.
// Error bound of each entry of the rotation: 64 u (1 + 1/s), where s is the sine of the angle
// between `up` and the gaze. It holds for a gaze near +z, too: -z has exact coordinates, and the
// cross product with it loses no digits. Error bound of the last column: the bound of the rotation
// times (1 + 2 D), where D is the largest coordinate of the eye in size.
Transform<Eye, World> axis_angle_view(const Camera& camera);

enum class Kind { kUnknown = -1, kNeither = 0, kRotation = 1, kMirror = 2 };

// Task 3.4. What the upper left 3 x 3 part of a matrix is: a rotation, a mirror (a rotation after a
// reflection), or neither. It is neither when an entry of R^T R - I is larger than 10^-5 in size,
// or is infinite or NaN. The last row and column of the matrix do not matter. In all matrices that
// are tested, the largest of these entries is below 10^-6 or above 10^-4.
Kind kind_of(const Transform<World, World>& matrix);

// Task 3.5. Changes a projection that expects a left-handed eye space (x right, y up, z into the
// scene, as on the slides S4.17 to S4.20) into one for our eye space. The projection may be any
// matrix: parallel, or with a window that is not in the middle. Exact: the entries are those given,
// up to their signs.
Transform<Clip, Eye> for_right_handed_eye(const Transform<Clip, Eye>& clip_from_left_handed_eye);

}  // namespace lab_03
