// Lab 2: affine maps of the plane and of space. The contracts of the five functions that you write
// in student.cpp.
//
// Column vectors: p' = M p. The translation is in the last column, and in A B the map B acts first.
// Rows and columns are counted from 0. The world is right-handed; a positive angle turns
// counter-clockwise for a viewer whom the axis points at. Everything is in double; u = 2^-53 is its
// unit roundoff.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glassbox/base/spaces.h>

namespace lab_02 {

// The types of <glassbox/base/spaces.h>, which comes with glassbox; this is all that you need:
//   Vector<Space, double>      v.x, v.y, v.z; v + w, v - w, -v, v * number; dot(v, w), cross(v, w)
//   Transform<Target, Source>  a 4 x 4 matrix of doubles, at first the identity: m.at(row, column);
//                              a * b: a Transform<C, B> times a Transform<B, A> is a
//                              Transform<C, A>
using glassbox::Object;
using glassbox::Transform;
using glassbox::Vector;
using glassbox::World;

struct Point2 {
  double x = 0, y = 0;
};

// A map of the plane in homogeneous coordinates: at[row][column]. The last row of an affine map is
// (0, 0, 1).
struct Matrix3 {
  double at[3][3] = {};
};

// Task 2.1. The map that turns the plane about `centre`, counter-clockwise (x to the right, y up),
// by -360 to 360 degrees. The coordinates of the centre are at most 2^1000 in size.
// Error bound of the last column's x and y: 24 u (1 + |centre.x| + |centre.y|); of the upper left
// 2 x 2 part: 24 u. The last row is exactly (0, 0, 1).
Matrix3 turn_about(const Point2& centre, double degrees);

struct Step {
  enum class Kind {
    kTranslate,  // moves by v
    // turns about the axis v through the origin, by `amount` degrees, -360 to 360. The axis has any
    // length but 0, so its components may be as small as 2^-1074, or as large as 2^1023
    kRotate,
    kScale,  // multiplies x, y and z by the components of v
    // adds amount * (coordinate `by`) to coordinate `changed`; 0, 1, 2 are x, y, z; `by` and
    // `changed` differ
    kShear
  };
  Kind kind = Kind::kTranslate;
  Vector<World, double> v{0, 0, 0};
  double amount = 0;
  int changed = 0, by = 1;
};

// Task 2.2. All steps as one matrix; steps[0] is done first. No steps give the identity.
// Error bound of each entry: 64 k u P, where k is the number of steps and P the product of the
// steps' norms, which is below 2^500. The norm of a matrix here is the largest sum of the sizes of
// a row's entries.
Transform<World, Object> compose(const std::vector<Step>& steps);

// Task 2.3. The affine map of the plane that maps source[i] to target[i]; std::nullopt if the
// three source points are on one line. Coordinates are integers up to 2^20 in size, so that their
// differences, and sums of two products of differences, are exact.
// Error bound of the upper left 2 x 2 part: 16 c u A, where A is its largest entry in size,
// c = |E| |E^-1| the condition number of E, E the matrix whose columns are source[1] - source[0]
// and source[2] - source[0], and |.| of a matrix the largest sum of the sizes of a column's
// entries. The bound does not depend on how far from the origin the points are. Error bound of the
// last column: the bound of the 2 x 2 part times (1 + |x| + |y|) of source[0], plus 4 u times the
// largest |coordinate| of target[0]. The last row is exactly (0, 0, 1).
std::optional<Matrix3> fit_affine(const std::array<Point2, 3>& source,
                                  const std::array<Point2, 3>& target);

struct AxisAngle {
  Vector<World, double> axis{0, 0, 1};  // of length 1
  double radians = 0;                   // 0 to pi
};

// Task 2.4. The axis and the angle of a rotation whose entries are correct up to one rounding. Its
// angle is 0 or at least 10^-6, and half a turn or at least 5 * 10^-8 less. For the identity the
// axis is z. At exactly half a turn, where the matrix is symmetric and both directions of the axis
// are right, choose the one whose first component that is not zero is positive. Error bound of the
// axis: 32 u in each component. The relative error of the angle is at most 32 u, for small angles
// too.
AxisAngle axis_angle_of(const Transform<World, World>& rotation);

// Task 2.5. A rotation Q near a matrix R that should be a rotation, but has drifted away by
// rounding or was written with few digits. R has a positive determinant. The largest entry of
// R^T R - I in size is called d here; it is at most 0.01. Q must have a positive determinant, the
// entries of Q^T Q - I must be at most 16 u in size, and each entry of Q may differ by at most
// 3 d + 16 u from that of R. The last column and row are those of the identity, in R and in Q.
Transform<World, World> repaired(const Transform<World, World>& almost_rotation);

}  // namespace lab_02
