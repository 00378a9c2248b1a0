// Lab 2: affine maps of the plane and of space. The contracts of the five functions that you write in student.cpp.
//
// Column vectors: p' = M p, M[row][column], the translation stands in the last column, and in A B the map B acts first.
// The world is right-handed; a positive angle turns counter-clockwise for a viewer whom the axis points at. Everything is
// in double; u = 2^-53 is its rounding unit.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glassbox/base/spaces.h>

namespace lab_02 {

using glassbox::Object;
using glassbox::Transform;
using glassbox::Vector;
using glassbox::World;

struct Point2 {
  double x = 0, y = 0;
};

// A map of the plane in homogeneous coordinates: at[row][column]. The last row of an affine map is (0, 0, 1).
struct Matrix3 {
  double at[3][3] = {};
};

// Task 2.1. The map that turns the plane about `centre`, counter-clockwise (x to the right, y up), by -360 to 360 degrees.
// Bound of each entry: 24 u (1 + |centre.x| + |centre.y|).
Matrix3 turn_about(const Point2& centre, double degrees);

struct Step {
  enum class Kind {
    kTranslate,  // by v
    kRotate,  // about the axis v (of any length but 0) through the origin, by `amount` degrees, -360 to 360
    kScale,  // x, y and z by the components of v
    kShear  // adds amount * (coordinate `by`) to coordinate `changed`; 0, 1, 2 are x, y, z, and they differ
  };
  Kind kind = Kind::kTranslate;
  Vector<World, double> v{0, 0, 0};
  double amount = 0;
  int changed = 0, by = 1;
};

// Task 2.2. All steps as one matrix; steps[0] is done first. No steps: the identity.
// Bound of each entry: 64 k u P, where k is the number of steps and P the product of the steps' norms (the largest sum of
// the sizes of a row's entries).
Transform<World, Object> compose(const std::vector<Step>& steps);

// Task 2.3. The affine map of the plane that carries source[i] to target[i]; nothing if the source points lie on a line.
// Coordinates are integers up to 2^20 in size, so that their differences, and sums of two products of those, are exact.
// Bound of the upper left 2 x 2: 16 c u A, where A is its largest entry in size, c = |E| |E^-1| its condition, E the matrix
// whose columns are source[1] - source[0] and source[2] - source[0], and | | the largest sum of the sizes of a column's entries.
// It does not depend on how far from the origin the points are. Bound of the last column: that times
// (1 + |x| + |y|) of source[0], plus 4 u times the largest |coordinate| of target[0].
std::optional<Matrix3> fit_affine(const std::array<Point2, 3>& source,
                                  const std::array<Point2, 3>& target);

struct AxisAngle {
  Vector<World, double> axis{0, 0, 1};  // of length 1
  double radians = 0;                   // 0 to pi
};

// Task 2.4. The axis and the angle of a rotation, whose entries are right to a rounding. The identity has the z axis. At exactly
// half a turn, where the matrix is symmetric and both directions of the axis are right, the one whose first
// component that is not zero is positive.
// Bound of the axis: 32 u in each component. Relative error of the angle at most 32 u, for angles of 10^-6 too.
AxisAngle axis_angle_of(const Transform<World, World>& rotation);

// Task 2.5. A rotation near a matrix that should be one, but has drifted away by rounding or was written with few digits.
// Of the matrix R given, every entry of R^T R - I is at most d = 0.01 in size, and its determinant is positive.
// Of the result the same entries are at most 16 u, its determinant is positive, and no entry of it is further than
// 3 d + 16 u from that of R. The last column and row are those of the identity, there and here.
Transform<World, World> repaired(const Transform<World, World>& almost_rotation);

}  // namespace lab_02
